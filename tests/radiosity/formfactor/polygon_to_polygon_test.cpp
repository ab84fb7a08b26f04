#include "aktina/radiosity/formfactor/polygon_to_polygon.h"

#include <gtest/gtest.h>

#include "aktina/radiosity/formfactor/closed_forms.h"
#include "polygons.h"

namespace aktina {
namespace {

double factor(const Polygon& a, const Polygon& b) { return exchange_area(face(a), face(b)) / face(a).area; }

TEST(PolygonToPolygon, KnownValues) {
  EXPECT_NEAR(factor(unit_square(), ceiling(1)), 0.199824895698, 1e-12);
  EXPECT_NEAR(factor(unit_square(), hinged(kPi / 2)), 0.200043776075, 1e-12);
  const double degrees[] = {30, 45, 60, 90, 120, 150};
  const double known[] = {0.61902832, 0.48334770, 0.37090532, 0.20004378, 0.08661500, 0.02134533};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(factor(unit_square(), hinged(degrees[i] * kPi / 180)), known[i], 5e-9);
}

TEST(PolygonToPolygon, OpposedSquaresAtAnyDistance) {
  for (const double h : {1e-6, 1e-3, 0.1, 1.0, 5.0, 20.0}) {
    const double exact = opposed_rectangles(1, 1, h);
    EXPECT_NEAR(factor(unit_square(), ceiling(h)), exact, 1e-13 + 1e-11 * exact) << h;
  }
  EXPECT_NEAR(factor(unit_square(), ceiling(1e5)) * kPi * 1e10, 1, 1e-9);
}

TEST(PolygonToPolygon, BoxesAndPrismsClose) {
  const auto closes = [](const std::vector<Polygon>& walls) {
    for (const Polygon& a : walls) {
      double sum = 0;
      for (const Polygon& b : walls)
        if (&a != &b) sum += factor(a, b);
      EXPECT_NEAR(sum, 1, 1e-12);
    }
  };
  closes(box(1, 1, 1));
  closes(box(1, 1.5, 0.8));
  closes(box(100, 1, 0.1));
  // A triangular prism.
  closes({{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}},
          {{{0, 0, 1}, {0, 2, 1}, {3, 0, 1}}},
          {{{0, 0, 0}, {0, 0, 1}, {3, 0, 1}, {3, 0, 0}}},
          {{{3, 0, 0}, {3, 0, 1}, {0, 2, 1}, {0, 2, 0}}},
          {{{0, 2, 0}, {0, 2, 1}, {0, 0, 1}, {0, 0, 0}}}});
}

TEST(PolygonToPolygon, ScaleAndPlaceDoNotMatter) {
  for (const double scale : {1e-6, 1.0, 1e6})
    for (const Vec3d& by : {Vec3d(0), Vec3d(30, -20, 10)}) {
      EXPECT_NEAR(factor(moved(unit_square(), by, scale), moved(ceiling(1), by, scale)), 0.19982489569838738, 1e-12);
      EXPECT_NEAR(factor(moved(unit_square(), by, scale), moved(hinged(1.2), by, scale)),
                  factor(unit_square(), hinged(1.2)), 1e-12);
    }
}

TEST(PolygonToPolygon, RandomTrianglesAgreeWithBruteQuadratureAndReciprocity) {
  rc::check([] {
    const Face a = face(random_triangle({0, 0, 0})), b = face(random_triangle({0.5, 0, 4}));
    const double exact = exchange_area(a, b);
    RC_ASSERT(exact == exchange_area(a, b));
    RC_ASSERT(std::abs(exact - exchange_area(b, a)) < 1e-14);
    if (facing_parts(a, b).a == a.vertices && facing_parts(a, b).b == b.vertices)
      RC_ASSERT(std::abs(exact - brute_exchange(a, b, 10)) < 1e-6 * exact + 1e-12);
  });
}

TEST(PolygonToPolygon, SplittingIsAdditiveAlsoWhereTheyCrossEachOther) {
  rc::check([] {
    const Polygon a = random_triangle({0, 0, 0}), b = random_triangle({0, 0, 0.3});
    const Point3d p = b.vertices[0], q = b.vertices[1], r = b.vertices[2], m = 0.4 * q + 0.6 * r;
    const Face fa = face(a);
    RC_ASSERT(std::abs(exchange_area(fa, face(b)) - exchange_area(fa, face({{p, q, m}})) -
                       exchange_area(fa, face({{p, m, r}}))) < 1e-11);
  });
}

TEST(PolygonToPolygon, HostilePairs) {
  EXPECT_EQ(factor(unit_square(), unit_square()), 0) << "itself";
  EXPECT_EQ(factor(unit_square(), turned_over(unit_square())), 0) << "coincident, facing away";
  EXPECT_EQ(factor(unit_square(), moved(unit_square(), {1, 0, 0})), 0) << "coplanar neighbours";
  EXPECT_EQ(factor(unit_square(), moved(unit_square(), {0, 0, 1})), 0) << "the other's back";
  // A needle has the factor of a point to first order.
  const Polygon needle{{{0.5, 0.5, 0}, {0.5 + 1e-7, 0.5, 0}, {0.5, 0.6, 0}}};
  EXPECT_NEAR(factor(needle, ceiling(1)), 0.2394, 1e-3);
  // Edges that only partly overlap: the wall reaches beyond the floor.
  const double both = factor(unit_square(), {{{0, -1, 0}, {0, 2, 0}, {0, 2, 1}, {0, -1, 1}}});
  const double parts = factor(unit_square(), {{{0, -1, 0}, {0, 0, 0}, {0, 0, 1}, {0, -1, 1}}});
  EXPECT_NEAR(both, 0.20004377607540316 + 2 * parts, 1e-14);
}

TEST(LogIntegral, CloseParallelTouchingAndCrossingEdges) {
  // int_0^1 int_0^1 ln (s - t)^2 = -3, the same edge twice.
  EXPECT_NEAR(log_integral({0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, 1), -3, 1e-15);
  // End to end: int int ln (s + t)^2 = 4 ln 2 - 3.
  EXPECT_NEAR(log_integral({0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {-1, 0, 0}, 1), 4 * std::log(2.0) - 3, 1e-15);
  // At a right angle: int int ln (s^2 + t^2) = ln 2 - 3 + pi / 2.
  const double corner = std::log(2.0) - 3 + kPi / 2;
  EXPECT_NEAR(log_integral({0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, 1), corner, 1e-15);
  EXPECT_NEAR(log_integral({0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, 1), 4 * corner, 1e-14) << "crossing";
  EXPECT_NEAR(log_integral({0, -1, 0}, {0, 1, 0}, {-1, 0, 1e-9}, {1, 0, 1e-9}, 1), 4 * corner, 1e-8);
}

}  // namespace
}  // namespace aktina
