#include <gtest/gtest.h>

#include "illumination/light/light_checks.h"

namespace aktina {
namespace {

Point3 at_angle(float angle) { return {std::sin(angle), 0, -std::cos(angle)}; }

TEST(SpotLight, SmoothConeOfKhrLightsPunctual) {
  const SpotLight lamp{.intensity = Intensity(Rgb(10)), .inner_angle = 0.3f, .outer_angle = 0.6f};
  EXPECT_FLOAT_EQ(sample(lamp, at_angle(0)).e_perp.v.g, 10);
  EXPECT_FLOAT_EQ(sample(lamp, at_angle(0.29f)).e_perp.v.g, 10) << "full inside the inner cone";
  EXPECT_EQ(sample(lamp, at_angle(0.61f)).e_perp.v.g, 0) << "nothing outside the outer one";
  const float halfway = std::acos((std::cos(0.3f) + std::cos(0.6f)) / 2);
  EXPECT_NEAR(sample(lamp, at_angle(halfway)).e_perp.v.g, 2.5f, 1e-4f) << "the square of a linear ramp in the cosine";
}

TEST(SpotLight, HardConeWithAPowerOfTheCosine) {
  const SpotLight lamp{.inner_angle = 0.5f, .outer_angle = 0.5f, .exponent = 3};
  EXPECT_NEAR(sample(lamp, at_angle(0.4f)).e_perp.v.g, std::pow(std::cos(0.4f), 3.0f), 1e-5f);
  EXPECT_EQ(sample(lamp, at_angle(0.51f)).e_perp.v.g, 0);
}

TEST(SpotLight, FluxIsTheIntegralOfItsIntensity) {
  const double cap = 2 * kPi * (1 - std::cos(0.5));  // solid angle of a cone of half angle 0.5
  EXPECT_NEAR(flux(SpotLight{.inner_angle = 0.5f, .outer_angle = 0.5f})->v.g, cap, 1e-5);
  const SpotLight smooth{.inner_angle = 0.2f, .outer_angle = 0.8f, .exponent = 2};
  EXPECT_NEAR(test::flux_through_sphere(smooth, 1, 1 << 14), flux(smooth)->v.g, 0.01 * flux(smooth)->v.g);
}

TEST(SpotLight, FluxOfNarrowBeamsInClosedForm) {
  for (const float exponent : {1.0f, 1000.0f, 1e5f})
    for (const float outer : {1.0f, float(kPi / 2), 3.0f}) {
      const SpotLight hard{
          .intensity = Intensity(Rgb(100)), .inner_angle = outer, .outer_angle = outer, .exponent = exponent};
      const double edge = std::max(0.0, std::cos(double(outer)));
      const double exact = 200 * kPi * (1 - std::pow(edge, double(exponent) + 1)) / (double(exponent) + 1);
      EXPECT_NEAR(flux(hard)->v.g, exact, 1e-5 * exact) << exponent << " " << outer;
      const SpotLight smooth{
          .intensity = Intensity(Rgb(100)), .inner_angle = 0.5f, .outer_angle = outer, .exponent = exponent};
      double sum = 0;  // midpoints, finer towards the axis
      constexpr int kSteps = 400'000;
      for (int k = 0; k < kSteps; ++k) {
        const double t = (k + 0.5) / kSteps, c = 1 - 2 * t * t * t;
        sum += double(spot_falloff(smooth, float(c))) * 6 * t * t / kSteps;
      }
      EXPECT_NEAR(flux(smooth)->v.g, 200 * kPi * sum, 2e-3 * 200 * kPi * sum) << exponent << " " << outer;
    }
}

TEST(SpotLight, NothingIsDarkBehindAConeOfAHalfTurn) {
  const SpotLight all{.direction = normalize(Vec3(1, 2, 3)), .inner_angle = float(kPi), .outer_angle = float(kPi)};
  for (int k = 1; k < 2000; ++k)
    EXPECT_GT(sample(all, all.position - all.direction * (0.01f * float(k))).e_perp.v.g, 0) << k;
}

TEST(SpotLight, AConeOfAHalfTurnIsAPointLight) {
  const SpotLight open{.inner_angle = float(kPi), .outer_angle = float(kPi)};
  for (const Point3 x : {Point3(1, 2, 3), Point3(0, 0, 2), Point3(0, 0, -2), Point3(0.1f, 0, 5)})
    EXPECT_FLOAT_EQ(sample(open, x).e_perp.v.g, sample(PointLight{}, x).e_perp.v.g);
}

TEST(SpotLight, AConeOfNothingIsDarkAndFinite) {
  for (const float exponent : {0.0f, -2.0f, 1e6f}) {
    const SpotLight closed{.inner_angle = 0, .outer_angle = 0, .exponent = exponent};
    EXPECT_EQ(sample(closed, at_angle(0.01f)).e_perp.v.g, 0);
    EXPECT_TRUE(is_finite(sample(closed, {0, 0, 0}).e_perp.v)) << "at the lamp itself";
    EXPECT_TRUE(is_finite(flux(closed)->v));
  }
}

}  // namespace
}  // namespace aktina
