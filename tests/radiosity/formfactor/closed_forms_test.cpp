// Closed forms against direct integrals of their definition, against limits, and against each other.
#include "aktina/radiosity/formfactor/closed_forms.h"

#include <gtest/gtest.h>

#include "aktina/radiosity/formfactor/point_to_polygon.h"
#include "polygons.h"

namespace aktina {
namespace {

/// A disc as a polygon of n corners of the same area.
Face polygonal_disc(Point3d centre, Vec3d u, Vec3d v, double radius, int n) {
  const double r = radius * std::sqrt(2 * kPi / (n * std::sin(2 * kPi / n)));
  Polygon polygon;
  for (int i = 0; i < n; ++i)
    polygon.vertices.push_back(centre + r * (std::cos(2 * kPi * i / n) * u + std::sin(2 * kPi * i / n) * v));
  return face(polygon);
}

TEST(PointToDisc, OnTheAxisAndOff) {
  EXPECT_NEAR(point_to_disc({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}, 1), 0.5, 1e-15);
  EXPECT_EQ(point_to_disc({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, 1), 0) << "its back";
  // Parallel, off the axis: (1 - (x^2 + z^2 - 1) / sqrt((1 + z^2 + x^2)^2 - 4 x^2)) / 2 for radius 1 [B-13].
  const double x = 1.5, z = 0.8, p = 1 + z * z + x * x;
  EXPECT_NEAR(point_to_disc({x, 0, 0}, {0, 0, 1}, {0, 0, z}, {0, 0, -1}, 1),
              0.5 * (1 - (x * x + z * z - 1) / std::sqrt(p * p - 4 * x * x)), 1e-15);
}

TEST(PointToDisc, IsTheLimitOfPolygonsAtSecondOrderAlsoAcrossTheHorizon) {
  rc::check([] {
    const Vec3d n = normalize(random_vector() + Vec3d(0, 0, 1e-3));
    const Point3d x = {random_coordinate(), random_coordinate(), 0};
    const double height = 0.6 + 0.4 * random_coordinate();
    const double exact = point_to_disc(x, n, {0, 0, height}, {0, 0, -1}, 0.7);
    const auto with = [&](int corners) {
      return point_to_polygon(x, n, polygonal_disc({0, 0, height}, {0, 1, 0}, {1, 0, 0}, 0.7, corners));
    };
    RC_ASSERT(std::abs(with(2048) - exact) < 1e-5);
  });
}

TEST(PointToSphere, EqualsItsIntegralOverTheCap) {
  const double radius = 1, distance = 1.3;
  for (const double degrees : {0.0, 20.0, 39.0, 40.0, 60.0, 89.0, 91.0, 120.0, 139.0, 141.0}) {
    const double angle = degrees * kPi / 180, half = std::asin(radius / distance);
    double sum = 0;  // of max(0, cos) / pi over the directions of the cap
    constexpr int kSteps = 1000;
    for (int i = 0; i < kSteps; ++i)
      for (int j = 0; j < kSteps; ++j) {
        const double theta = half * (i + 0.5) / kSteps, phi = kPi * (j + 0.5) / kSteps;
        const double cosine = std::cos(theta) * std::cos(angle) + std::sin(theta) * std::cos(phi) * std::sin(angle);
        sum += std::max(0.0, cosine) * std::sin(theta);
      }
    EXPECT_NEAR(point_to_sphere(radius, distance, angle), sum * 2 * half / (kSteps * kSteps), 2e-6) << degrees;
  }
}

TEST(PointToSphere, HasNoJumpAtTheHorizon) {
  const double half = std::asin(1 / 1.3);
  for (const double edge : {kPi / 2 - half, kPi / 2 + half})
    EXPECT_NEAR(point_to_sphere(1, 1.3, edge - 1e-9), point_to_sphere(1, 1.3, edge + 1e-9), 2e-9);
}

TEST(CoaxialDiscs, LimitsReciprocityAndAFarSmallOne) {
  EXPECT_NEAR(coaxial_discs(1, 1, 1), (3 - std::sqrt(5.0)) / 2, 1e-15);
  EXPECT_NEAR(coaxial_discs(1, 1, 1e-9), 1, 1e-8);
  EXPECT_NEAR(coaxial_discs(1, 3, 2), 9 * coaxial_discs(3, 1, 2), 1e-15);
  EXPECT_NEAR(coaxial_discs(1e-6, 0.5, 2) / point_to_disc({0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, -1}, 0.5), 1, 1e-10);
}

TEST(Rectangles, TheCubeCloses) {
  EXPECT_NEAR(opposed_rectangles(1, 1, 1), 0.199824895698, 1e-12);
  EXPECT_NEAR(perpendicular_rectangles(1, 1, 1), 0.200043776075, 1e-12);
  EXPECT_NEAR(opposed_rectangles(1, 1, 1) + 4 * perpendicular_rectangles(1, 1, 1), 1, 1e-15);
}

TEST(Spheres, TheirSharesClose) {
  EXPECT_DOUBLE_EQ(sphere_to_inner_sphere(1, 2), 0.25);
  EXPECT_NEAR(sphere_band(0, 0.4) + sphere_band(0.4, 1.1) + sphere_band(1.1, kPi), 1, 1e-15);
  const CapFactors f = spherical_cap(1.2);
  EXPECT_NEAR(f.cap_cap + f.cap_base, 1, 1e-15);
  const double cap_area = 2 * kPi * (1 - std::cos(1.2)), base_area = kPi * std::pow(std::sin(1.2), 2);
  EXPECT_NEAR(f.cap_base * cap_area, f.base_cap * base_area, 1e-14);
}

}  // namespace
}  // namespace aktina
