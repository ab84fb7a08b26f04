#include <gtest/gtest.h>

#include <cmath>

#include "illumination/light/area_checks.h"
#include "illumination/light/light_checks.h"

namespace aktina {
namespace {

// Two metres above the origin, 0.8 m x 1.2 m, shining down.
const RectangleLight kPanel{.corner = {-0.4f, 2, -0.6f}, .edge_u = {0.8f, 0, 0}, .edge_v = {0, 0, 1.2f}};

double irradiance(const Light& light, Point3 x, Vec3 n) {
  const LightSample s = sample(light, x);
  return double(s.e_perp.v.g) * double(dot(s.wi, n));
}

TEST(RectangleLight, FacesTheProductOfItsEdges) {
  EXPECT_EQ(sample(kPanel, {0, 0, 0}).e_perp.v.g > 0, true);
  EXPECT_EQ(sample(kPanel, {0, 3, 0}).e_perp.v.g, 0) << "behind";
  RectangleLight both = kPanel;
  both.both_sides = true;
  EXPECT_NEAR(sample(both, {0, 4, 0}).e_perp.v.g, sample(both, {0, 0, 0}).e_perp.v.g, 1e-6f);
  EXPECT_LT(sample(both, {0, 4, 0}).wi.y, 0);
}

TEST(RectangleLight, UnderItsCornerItIsTheKnownFormFactor) {
  // Howell B-3: a small plane parallel to a rectangle a x b at distance c, below a corner
  const double a = 0.8 / 2, b = 1.2 / 2;
  const double factor = 1 / (2 * kPi) *
                        (a / std::sqrt(1 + a * a) * std::atan(b / std::sqrt(1 + a * a)) +
                         b / std::sqrt(1 + b * b) * std::atan(a / std::sqrt(1 + b * b)));
  EXPECT_NEAR(irradiance(kPanel, {0.4f, 0, 0.6f}, {0, 1, 0}), kPi * factor, 1e-6);
}

TEST(RectangleLight, IsExactWhereTheWholeLampIsSeen) {
  const auto point = [](double u, double v) { return Vec3(-0.4 + 0.8 * u, 2, -0.6 + 1.2 * v); };
  for (const Point3 x : {Point3(0, 0, 0), Point3(1, 0.5f, -2), Point3(0.3f, 1.8f, 0.2f)})
    for (const Vec3 n : {Vec3(0, 1, 0), normalize(Vec3(-0.2f, 1, 0.3f))}) {
      const double exact = test::irradiance_by_points(point, 0.96, {0, -1, 0}, x, n, true);
      EXPECT_NEAR(irradiance(kPanel, x, n), exact, 1e-3 * std::abs(exact));
    }
}

TEST(RectangleLight, FarAwayItIsAPointThatFollowsTheCosine) {
  for (const float d : {30.0f, 3000.0f}) {
    const LightSample s = sample(kPanel, {0.6f * d, 2 - 0.8f * d, 0});
    EXPECT_NEAR(s.e_perp.v.g, 0.96f * 0.8f / (d * d), 1e-3f * 0.96f * 0.8f / (d * d)) << d;
    EXPECT_NEAR(s.distance, d, 0.02f * d);
    EXPECT_NEAR(dot(s.wi, Vec3(-0.6f, 0.8f, 0)), 1, 1e-4f);
  }
}

TEST(RectangleLight, FluxIsPiTimesRadianceTimesArea) {
  EXPECT_NEAR(flux(kPanel)->v.g, kPi * 0.96, 1e-5);
  const RectangleLight small{.corner = {-0.1f, 0, -0.1f}, .edge_u = {0.2f, 0, 0}, .edge_v = {0, 0, 0.2f}};
  EXPECT_NEAR(test::flux_through_sphere(small, 3, 1 << 13), flux(small)->v.g, 0.01 * flux(small)->v.g);
}

TEST(RectangleLight, OnItsOwnPlaneAndWithoutAreaItIsDark) {
  for (const Point3 x : {Point3(0, 2, 0), Point3(-0.4f, 2, -0.6f), Point3(5, 2, 0)})
    EXPECT_EQ(sample(kPanel, x).e_perp.v.g, 0);
  RectangleLight flat = kPanel;
  flat.edge_v = flat.edge_u;
  EXPECT_EQ(sample(flat, {0, 0, 0}).e_perp.v.g, 0);
}

}  // namespace
}  // namespace aktina
