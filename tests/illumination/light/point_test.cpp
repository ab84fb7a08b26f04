#include <gtest/gtest.h>

#include "illumination/light/light_checks.h"

namespace aktina {
namespace {

TEST(PointLight, HundredLumensGive7Point96LuxAtOneMetre) {
  const PointLight lamp{.position = {1, 2, 3}, .intensity = Intensity(Rgb(float(100 / (4 * kPi))))};
  EXPECT_NEAR(flux(lamp)->v.g, 100, 1e-4);
  EXPECT_NEAR(sample(lamp, {1, 2, 2}).e_perp.v.g, 7.9577f, 1e-4f);
  EXPECT_NEAR(sample(lamp, {1, 0, 3}).e_perp.v.g, 7.9577f / 4, 1e-4f) << "the inverse square law";
}

TEST(PointLight, AllItsFluxPassesASphereAboutIt) {
  const PointLight lamp{.position = {0.3f, -0.2f, 0.4f}, .intensity = Intensity(Rgb(2))};
  EXPECT_NEAR(test::flux_through_sphere(lamp, 1, 1 << 14), flux(lamp)->v.g, 0.01 * flux(lamp)->v.g)
      << "wherever it stands inside";
}

TEST(PointLight, AtTheLightItselfNothingIsInfinite) {
  const LightSample s = sample(PointLight{}, {0, 0, 0});
  EXPECT_TRUE(is_finite(s.e_perp.v));
  EXPECT_TRUE(is_finite(s.wi));
}

TEST(PointLight, ClassicAttenuation) {
  const PointLight lamp{.attenuation = {.a0 = 1, .a1 = 0.5f, .a2 = 0.25f, .clamp = true}};
  EXPECT_FLOAT_EQ(sample(lamp, {2, 0, 0}).e_perp.v.g, 1.0f / 3);
  const PointLight bright{.attenuation = {.a0 = 0, .a1 = 0.1f, .a2 = 0, .clamp = true}};
  EXPECT_FLOAT_EQ(sample(bright, {2, 0, 0}).e_perp.v.g, 1) << "never more than the light itself";
}

}  // namespace
}  // namespace aktina
