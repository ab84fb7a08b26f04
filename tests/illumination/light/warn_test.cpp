#include <gtest/gtest.h>

#include "illumination/light/light_checks.h"

namespace aktina {
namespace {

Point3 at_angle(float angle) { return {std::sin(angle), 0, -std::cos(angle)}; }

TEST(WarnLight, FallsOffAsAPowerOfTheCosineWithinItsCone) {
  const WarnLight lamp{.intensity = Intensity(Rgb(3)), .exponent = 4, .cone_angle = 0.7f};
  for (const float angle : {0.0f, 0.3f, 0.69f})
    EXPECT_NEAR(sample(lamp, at_angle(angle)).e_perp.v.g, 3 * std::pow(std::cos(angle), 4.0f), 1e-5f);
  EXPECT_EQ(sample(lamp, at_angle(0.71f)).e_perp.v.g, 0);
}

TEST(WarnLight, ShinesForwardsOnlyWithoutACone) {
  for (const float exponent : {0.0f, 1.0f, 1e6f})
    EXPECT_EQ(sample(WarnLight{.exponent = exponent}, at_angle(1.6f)).e_perp.v.g, 0) << exponent;
  EXPECT_EQ(sample(WarnLight{.exponent = 0}, at_angle(1.5f)).e_perp.v.g, 1);
}

TEST(WarnLight, FlapsKeepItsLightWithinABox) {
  WarnLight lamp;
  lamp.exponent = 0;
  lamp.flap_low.x = -0.1f, lamp.flap_high.x = 0.2f;  // a slit; the other flaps are open
  EXPECT_GT(sample(lamp, {0.19f, 5, -1}).e_perp.v.g, 0);
  EXPECT_EQ(sample(lamp, {0.21f, 5, -1}).e_perp.v.g, 0);
  EXPECT_EQ(sample(lamp, {-0.11f, 5, -1}).e_perp.v.g, 0);
  lamp.flap_high.y = 4;
  EXPECT_EQ(sample(lamp, {0.19f, 5, -1}).e_perp.v.g, 0);
}

TEST(WarnLight, WithoutConeAndFlapsItIsASpotOfARightAngle) {
  const WarnLight lamp{.exponent = 3};
  const SpotLight spot{.inner_angle = float(kPi / 2), .outer_angle = float(kPi / 2), .exponent = 3};
  for (const float angle : {0.0f, 0.5f, 1.2f, 1.5f})
    EXPECT_NEAR(sample(lamp, at_angle(angle)).e_perp.v.g, sample(spot, at_angle(angle)).e_perp.v.g, 1e-6f);
  EXPECT_NEAR(flux(lamp)->v.g, 2 * kPi / 4, 1e-6) << "2 pi / (p + 1)";
  EXPECT_NEAR(test::flux_through_sphere(lamp, 1, 1 << 14), flux(lamp)->v.g, 0.01 * flux(lamp)->v.g);
}

}  // namespace
}  // namespace aktina
