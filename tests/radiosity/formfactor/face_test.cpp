// Polygons are looked at once: what is hostile is refused, what is odd is taken as it is.
#include "aktina/radiosity/formfactor/face.h"

#include <gtest/gtest.h>

#include "aktina/base/error.h"
#include "polygons.h"

namespace aktina {
namespace {

const Polygon kL{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}};

double area(const std::vector<Contour>& pieces) {
  double sum = 0;
  for (const Contour& piece : pieces) sum += length(newell_normal({piece}));
  return sum;
}

TEST(Face, KnowsAreaNormalAndPieces) {
  const Face l = face(kL);
  EXPECT_DOUBLE_EQ(l.area, 3);
  EXPECT_EQ(l.plane.normal, Vec3d(0, 0, 1));
  EXPECT_EQ(l.convex.size(), 4U);
  EXPECT_NEAR(area(l.convex), 3, 1e-15);
  EXPECT_EQ(face(unit_square()).convex.size(), 1U);
}

TEST(Face, CornersThatAreNoneAndRepeatedVerticesAreTaken) {
  const Face square = face({{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  EXPECT_DOUBLE_EQ(square.area, 1);
  EXPECT_NEAR(area(square.convex), 1, 1e-15);
}

TEST(Face, AnyStarIsCutIntoPiecesOfItsArea) {
  rc::check([] {
    Polygon star;
    const int n = *rc::gen::inRange(3, 12);
    for (int i = 0; i < n; ++i) {
      const double r = 1.1 + random_coordinate(), phi = 2 * kPi * i / n;
      star.vertices.push_back({r * std::cos(phi), 0, -r * std::sin(phi)});
    }
    const Face made = face(star);
    RC_ASSERT(std::abs(area(made.convex) - made.area) < 1e-12);
  });
}

TEST(Face, RefusesWhatIsNoPolygon) {
  const double nan = NAN;
  const Polygon bad[] = {
      {{}},
      {{{0, 0, 0}, {1, 0, 0}}},
      {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}},              // no area
      {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}},              // one point
      {{{0, 0, 0}, {1, 0, 0}, {1, nan, 0}}},            // not a number
      {{{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}}},      // its square is not finite
      {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}}  // not planar
  };
  for (const Polygon& polygon : bad) {
    try {
      make_face(polygon, "surface 7");
      FAIL() << polygon.vertices.size() << " vertices were taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Code::bad_input);
      EXPECT_EQ(error.where(), "surface 7");
    }
  }
}

TEST(Clip, KeepsTheFrontAndWhatTouchesCounts) {
  const Contour square = unit_square().vertices;
  const auto kept = [&](double x, double sign) {
    const Contour part = clip(square, {{x, 0, 0}, {sign, 0, 0}}, 1e-12);
    return part.empty() ? 0 : length(newell_normal({part}));
  };
  EXPECT_DOUBLE_EQ(kept(0.25, 1), 0.75);
  EXPECT_DOUBLE_EQ(kept(0.25, -1), 0.25);
  EXPECT_EQ(kept(1, 1), 0);
  EXPECT_EQ(kept(1, -1), 1);
  EXPECT_EQ(kept(1 - 1e-13, 1), 0) << "less than the margin is nothing";
}

TEST(Clip, AConcaveContourThatFallsApartKeepsItsArea) {
  const Contour u{{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  const Contour arms = clip(u, {{0, 1.5, 0}, {0, 1, 0}}, 1e-12);
  EXPECT_DOUBLE_EQ(length(newell_normal({arms})), 1);
}

TEST(Distance, OfPointsToAFace) {
  const Face l = face(kL);
  EXPECT_DOUBLE_EQ(distance(l, {0.5, 0.5, 3}), 3);
  EXPECT_DOUBLE_EQ(distance(l, {1.5, 1.5, 0}), 0.5);
  EXPECT_DOUBLE_EQ(distance(l, {5, 5, 0}), 5) << "from the corner (2, 1)";
}

}  // namespace
}  // namespace aktina
