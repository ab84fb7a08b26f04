#include <gtest/gtest.h>

#include <cmath>

#include "illumination/light/area_checks.h"
#include "illumination/light/light_checks.h"

namespace aktina {
namespace {

const DiscLight kDisc{.position = {0, 2, 0}, .direction = {0, -1, 0}, .radius = 0.7f};

double irradiance(const Light& light, Point3 x, Vec3 n) {
  const LightSample s = sample(light, x);
  return double(s.e_perp.v.g) * double(dot(s.wi, n));
}

TEST(DiscLight, OnItsAxisItIsTheKnownFormFactor) {
  for (const float h : {0.01f, 0.5f, 2.0f, 100.0f}) {
    const double r2 = 0.49, exact = kPi * r2 / (r2 + double(h) * double(h));
    EXPECT_NEAR(irradiance(kDisc, {0, 2 - h, 0}, {0, 1, 0}), exact, 1e-5 * exact) << h;
    EXPECT_NEAR(sample(kDisc, {0, 2 - h, 0}).distance, h, 1e-4f * h);
  }
}

TEST(DiscLight, IsExactForAnyPlaceAndPlane) {
  const auto point = [](double u, double v) {
    const double r = 0.7 * std::sqrt(u), phi = 2 * kPi * v;
    return Vec3(r * std::cos(phi), 2, r * std::sin(phi));
  };
  for (const Point3 x : {Point3(0.3f, 1, 0.2f), Point3(2, 0.5f, -1), Point3(0.69f, 1.5f, 0)})
    for (const Vec3 n : {Vec3(0, 1, 0), Vec3(-1, 0, 0), normalize(Vec3(-0.5f, 1, 0.3f))}) {
      const double exact = test::irradiance_by_points(point, kPi * 0.49, {0, -1, 0}, x, n, true);
      EXPECT_NEAR(irradiance(kDisc, x, n), exact, 2e-3 * std::abs(exact) + 1e-5);
    }
}

TEST(DiscLight, FluxIsPiTimesRadianceTimesArea) {
  EXPECT_NEAR(flux(kDisc)->v.g, kPi * kPi * 0.49, 1e-4);
  const DiscLight small{.radius = 0.1f, .both_sides = true};
  EXPECT_NEAR(test::flux_through_sphere(small, 3, 1 << 13), flux(small)->v.g, 0.01 * flux(small)->v.g);
}

TEST(DiscLight, OnItsPlaneItIsDark) {
  for (const Point3 x : {Point3(0, 2, 0), Point3(0.7f, 2, 0), Point3(3, 2, 1)})
    EXPECT_EQ(sample(kDisc, x).e_perp.v.g, 0);
  EXPECT_EQ(sample(kDisc, {0, 3, 0}).e_perp.v.g, 0) << "behind";
}

}  // namespace
}  // namespace aktina
