#include "aktina/radiosity/formfactor/point_to_polygon.h"

#include <gtest/gtest.h>

#include "polygons.h"

namespace aktina {
namespace {

constexpr Vec3d kUp(0, 0, 1);

TEST(PointToPolygon, KnownValues) {
  const auto centred = [](double h) { return point_to_polygon({0.5, 0.5, 0}, kUp, face(ceiling(h))); };
  EXPECT_NEAR(centred(1), 0.239456470461, 1e-12);
  EXPECT_NEAR(centred(0.5), 0.55413, 5e-6);
  EXPECT_NEAR(centred(0.2), 0.88465, 5e-6);
  EXPECT_NEAR(centred(2), 0.07348, 5e-6);
  EXPECT_NEAR(centred(1e-9), 1, 1e-8);
}

TEST(PointToPolygon, ABoxAroundAPointIsAllThatItSees) {
  rc::check([] {
    const Point3d x = Point3d(0.5, 0.75, 0.4) + 0.3 * random_vector();
    const Vec3d n = normalize(random_vector() + Vec3d(1e-3, 0, 0));
    double sum = 0;
    for (const Polygon& wall : box(1, 1.5, 0.8)) sum += point_to_polygon(x, n, face(wall));
    RC_ASSERT(std::abs(sum - 1) < 1e-14);
  });
}

TEST(PointToPolygon, SplittingIsAdditive) {
  rc::check([] {
    const Polygon whole = random_triangle({0, 0, 1.5});
    const Point3d a = whole.vertices[0], b = whole.vertices[1], c = whole.vertices[2], m = 0.3 * b + 0.7 * c;
    const Vec3d n = normalize(random_vector() + Vec3d(0, 0, 1.001));
    const auto from_here = [&](const Polygon& p) { return point_to_polygon({0, 0, 0}, n, face(p)); };
    RC_ASSERT(std::abs(from_here(whole) - from_here({{a, b, m}}) - from_here({{a, m, c}})) < 1e-14);
  });
}

TEST(PointToPolygon, IsContinuousAcrossTheHorizon) {
  const Face wall = face({{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}});
  const auto tilted = [&](double angle) {
    return point_to_polygon({1, 0.5, 0}, {-std::sin(angle), 0, std::cos(angle)}, wall);
  };
  EXPECT_NEAR(tilted(1e-9), tilted(-1e-9), 2e-9) << "the wall's lower edge is in the horizon plane between them";
  const double over_the_top = -kPi / 4;
  EXPECT_EQ(tilted(over_the_top - 1e-9), 0);
  EXPECT_NEAR(tilted(over_the_top + 1e-6), 0, 1e-6);
}

TEST(PointToPolygon, FarAwayTheFormulasMeet) {
  const Face square = face(ceiling(0));
  for (const double distance : {100.0, 1e4, 1e8}) {  // on both sides of the switch at 100 sizes
    const double f = point_to_polygon({0.5, 0.5, -distance}, kUp, square);
    EXPECT_NEAR(f * kPi * distance * distance, 1, 1.01 / (3 * distance * distance) + 1e-14) << distance;
  }
  const double s = std::sqrt(2.0);  // the size by which the switch goes
  const double before = point_to_polygon({0.5, 0.5, -100 * s * 0.995}, kUp, square),
               after = point_to_polygon({0.5, 0.5, -100 * s * 1.005}, kUp, square);
  EXPECT_NEAR(before * 0.995 * 0.995, after * 1.005 * 1.005, 1e-6 * after);
}

TEST(PointToPolygon, BackEdgeOnAndCoplanarAreExactlyZero) {
  EXPECT_EQ(point_to_polygon({0.5, 0.5, 0}, kUp, face(moved(unit_square(), {0, 0, 1}))), 0);
  EXPECT_EQ(point_to_polygon({0.5, 0.5, 2}, kUp, face(ceiling(1))), 0);
  EXPECT_EQ(point_to_polygon({3, 0.5, 1}, kUp, face(ceiling(1))), 0);
}

TEST(PointToPolygon, OfAConcavePolygonIsThatOfItsParts) {
  const Face u = face({{{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}});
  const Face parts[] = {face({{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}}}),
                        face({{{0, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}}),
                        face({{{2, 1, 0}, {3, 1, 0}, {3, 2, 0}, {2, 2, 0}}})};
  const Point3d x(1.5, -1, 0.5);
  const Vec3d n = normalize(Vec3d(0, 1, 0.2));  // its horizon cuts both arms from the rest
  double sum = 0;
  for (const Face& part : parts) sum += point_to_polygon(x, n, part);
  EXPECT_GT(sum, 0);
  EXPECT_NEAR(point_to_polygon(x, n, u), sum, 1e-15);
}

/// Sources, points and occluders in between at random.
struct Random {
  Face source = face(random_triangle({0, 0, 3})), one = face(random_triangle({0, 0, 1.2})),
       two = face(random_triangle({0, 0, 1.2}));
  Vec3d n = normalize(random_vector() + Vec3d(0, 0, 2));
  double past(std::vector<const Face*> occluders) const { return point_to_polygon({0, 0, 0}, n, source, occluders); }
};

TEST(PointPastOccluders, HidesAsSetsDo) {
  rc::check([] {
    const Random r;
    const double all = r.past({}), one = r.past({&r.one}), two = r.past({&r.two}), both = r.past({&r.one, &r.two});
    RC_ASSERT(one <= all && two <= all && both <= std::min(one, two) + 1e-14);
    RC_ASSERT(both >= one + two - all - 1e-14);  // hidden by both is no more than hidden by each
    RC_ASSERT(std::abs(both - r.past({&r.two, &r.one})) < 1e-13);
    RC_ASSERT(std::abs(r.past({&r.one, &r.one}) - one) < 1e-13);
  });
}

TEST(PointPastOccluders, AgreesWithCountedRays) {
  rc::check([] {
    const Random r;
    if (r.source.plane.height({0, 0, 0}) < 0.05) return;
    const auto hits = [](const Face& f, Vec3d d) {
      const double t = -f.plane.height({0, 0, 0}) / dot(f.plane.normal, d);
      if (!(t > 0)) return INFINITY * 1.0;
      for (size_t i = 0; i < 3; ++i)
        if (dot(f.plane.normal, cross(f.vertices[(i + 1) % 3] - f.vertices[i], t * d - f.vertices[i])) < 0)
          return INFINITY * 1.0;
      return t;
    };
    double sum = 0;
    constexpr int kGrid = 60;
    for (const SurfaceSample& s : gauss_points(r.source.vertices, r.source.plane.normal, 30)) {
      const double t = std::min(hits(r.one, s.x), hits(r.two, s.x));
      const double squared = squared_length(s.x);
      if (t > 1)
        sum += s.area * std::max(0.0, dot(r.n, s.x)) * std::max(0.0, -dot(r.source.plane.normal, s.x)) /
               (kPi * squared * squared);
    }
    RC_ASSERT(std::abs(sum - r.past({&r.one, &r.two})) < 0.05 * r.past({}) + 1.0 / (kGrid * kGrid));
  });
}

TEST(PointPastOccluders, EdgesInTheHorizonPlaneAndPlanesThroughThePoint) {
  const Face wall = face({{{0, -1, 0}, {0, 1, 0}, {0, 1, 2}, {0, -1, 2}}});
  const Point3d x(2, 0, 0);
  const auto past = [&](const Polygon& p) {
    const Face occluder = face(p);
    const Face* list[] = {&occluder};
    return point_to_polygon(x, kUp, wall, list);
  };
  const double all = point_to_polygon(x, kUp, wall);
  // A screen that stands in the horizon plane, half as high as the line of sight to the wall's top.
  const double above = point_to_polygon(x, kUp, face({{{0, -1, 1}, {0, 1, 1}, {0, 1, 2}, {0, -1, 2}}}));
  EXPECT_NEAR(past({{{1, -5, 0}, {1, 5, 0}, {1, 5, 0.5}, {1, -5, 0.5}}}), above, 1e-15);
  EXPECT_NEAR(past({{{1, -5, -3}, {1, 5, -3}, {1, 5, 0.5}, {1, -5, 0.5}}}), above, 1e-15);
  EXPECT_EQ(past({{{1, -5, -3}, {1, 5, -3}, {1, 5, 0}, {1, -5, 0}}}), all) << "all of it is below the horizon";
  EXPECT_EQ(past({{{1.5, 0, -1}, {0.5, 0, -1}, {0.5, 0, 1}, {1.5, 0, 1}}}), all) << "seen edge-on";
  EXPECT_EQ(past({{{-1, -5, 0}, {-1, 5, 0}, {-1, 5, 5}, {-1, -5, 5}}}), all) << "behind the wall";
}

}  // namespace
}  // namespace aktina
