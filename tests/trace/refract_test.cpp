#include "aktina/trace/refract.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "aktina/illumination/facets.h"

namespace aktina {
namespace {

struct Incidence {
  Vec3d in, n;
  double cosine, sine;
};

/// Any direction that falls on any plane, from a few whole numbers.
Incidence incidence(int a, int b, int c, int d) {
  const double z = std::cos(0.01 * (a % 157)), phi = 0.1 * b, theta = 0.07 * c, turn = 0.3 * d;
  const double r = std::sqrt(1 - z * z);
  const Frame frame(normalize(
      Vec3(float(std::sin(theta) * std::cos(turn)), float(std::cos(theta)), float(std::sin(theta) * std::sin(turn)))));
  const Vec3d n = normalize(Vec3d(frame.n)), t = normalize(cross(n, Vec3d(frame.t))), u = cross(n, t);
  const Vec3d in = normalize(-z * n + r * std::cos(phi) * t + r * std::sin(phi) * u);
  return {in, n, -dot(in, n), length(cross(in, n))};
}

RC_GTEST_PROP(Refraction, FollowsSnellsLawInItsPlane, ()) {
  const auto i = incidence(*rc::gen::inRange(0, 157), *rc::gen::inRange(0, 63), *rc::gen::inRange(0, 45),
                           *rc::gen::inRange(0, 21));
  const double kn = *rc::gen::inRange(50, 250) / 100.0;
  const auto out = refract_direction(i.in, i.n, kn);
  RC_ASSERT(out.has_value() == (i.sine <= kn));
  if (!out) return;
  RC_ASSERT(std::abs(length(*out) - 1) < 1e-12);
  RC_ASSERT(std::abs(length(cross(*out, i.n)) * kn - i.sine) < 1e-7);  // near grazing the sine is all but 1
  RC_ASSERT(std::abs(dot(cross(i.in, i.n), *out)) < 1e-9);
  RC_ASSERT(dot(*out, i.n) <= 0);
  const auto whitted = refract_direction_whitted(i.in, i.n, kn);
  RC_ASSERT(whitted.has_value());
  RC_ASSERT(length(*whitted - *out) < 1e-6);
}

RC_GTEST_PROP(Refraction, IsReversible, ()) {
  const auto i = incidence(*rc::gen::inRange(0, 150), *rc::gen::inRange(0, 63), *rc::gen::inRange(0, 45),
                           *rc::gen::inRange(0, 21));
  const double kn = *rc::gen::inRange(100, 250) / 100.0;
  const auto out = refract_direction(i.in, i.n, kn);
  RC_ASSERT(out.has_value());
  const auto back = refract_direction(-*out, i.n, 1 / kn);
  RC_ASSERT(back.has_value() && length(*back + i.in) < 1e-6);
}

TEST(Refraction, EqualIndicesChangeNothing) {
  const Vec3d in = normalize(Vec3d(1, -2, 0.5));
  EXPECT_LT(length(*refract_direction(in, {0, 1, 0}, 1) - in), 1e-15);
  EXPECT_LT(length(*refract_direction_whitted(in, {0, -1, 0}, 1) - in), 1e-15);
  EXPECT_EQ(fresnel_reflectance(0.3, 1).unpolarized(), 0);
}

TEST(Refraction, MirrorKeepsTheAngle) {
  const Vec3d in = normalize(Vec3d(1, -2, 0.5)), n = normalize(Vec3d(0.2, 1, 0.1)), out = reflect_direction(in, n);
  EXPECT_NEAR(dot(out, n), -dot(in, n), 1e-15);
  EXPECT_NEAR(length(out), 1, 1e-15);
  EXPECT_LT(length(reflect_direction(in, -n) - out), 1e-15);
}

TEST(Fresnel, KnownValues) {
  EXPECT_NEAR(fresnel_reflectance(1, 1.5).unpolarized(), 0.04, 1e-15);
  const double brewster = std::atan(1.5);  // no light polarized in the plane is reflected
  EXPECT_NEAR(fresnel_reflectance(std::cos(brewster), 1.5).p, 0, 1e-15);
  EXPECT_NEAR(fresnel_reflectance(0, 1.5).unpolarized(), 1, 1e-15);
  EXPECT_EQ(fresnel_reflectance(std::cos(std::asin(1 / 1.5) + 1e-6), 1 / 1.5).unpolarized(), 1);
  for (const double c : {0.05, 0.3, 0.7, 1.0}) {
    EXPECT_NEAR(double(fresnel_dielectric(float(c), 1.5f)), fresnel_reflectance(c, 1.5).unpolarized(), 1e-6);
    // The same share both ways through the boundary.
    const double out = std::sqrt(1 - (1 - c * c) / 2.25);
    EXPECT_NEAR(fresnel_reflectance(out, 1 / 1.5).s, fresnel_reflectance(c, 1.5).s, 1e-12);
  }
}

}  // namespace
}  // namespace aktina
