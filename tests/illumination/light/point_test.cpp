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

TEST(PointLight, FarAwayItIsParallelLight) {
  // Q = P0 - s D: direction and, without attenuation, illuminance approach a directional light's as 1 / s
  const Vec3 d = normalize(Vec3(0.3f, -1, 0.2f));
  float before = 0;
  for (const float s : {100.0f, 1000.0f, 10000.0f}) {
    const LightSample near = sample(PointLight{.position = -s * d, .attenuation = {1, 0, 0, true}}, {1, 0, 2});
    const float off = length(near.wi + d);
    EXPECT_EQ(near.e_perp.v.g, 1);
    if (before > 0) {
      EXPECT_NEAR(before / off, 10, 0.5f);
    }
    before = off;
  }
}

TEST(PointLight, DepthCueingIsAFactorOfItsOwn) {
  EXPECT_EQ(depth_cue(0.5f, 0, 3), depth_cue(0.5f, 0, 300)) << "k2 = 0: constant";
  EXPECT_EQ(depth_cue(1, 1, 3), 0.25f);
  for (int k = 0; k < 20; ++k) EXPECT_GT(depth_cue(1, 0.1f, 0.5f * float(k)), depth_cue(1, 0.1f, 0.5f * float(k + 1)));
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
