#include "aktina/trace/scattering.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/random.h"
#include "aktina/base/statistics.h"

namespace aktina {
namespace {

Surface dielectric(Rgb base, float roughness) {
  Surface s;
  s.base = base, s.metallic = 0, s.roughness = roughness;
  return s;
}
Surface metal(float roughness) {
  Surface s = dielectric(Rgb(1), roughness);
  s.metallic = 1;
  return s;
}
Surface glass(float roughness) {
  Surface s = dielectric(Rgb(1), roughness);
  s.transmission = 1;
  return s;
}
Vec3 direction(float cosine) { return {std::sqrt(1 - cosine * cosine), 0, cosine}; }

/// Mean weight of sampled directions: what a uniform white surrounding would look like.
RunningStatistics albedo(const Scattering& s, Vec3 wo, bool inside, int n = 20000) {
  RunningStatistics result;
  for (int i = 0; i < n; ++i) {
    const auto k = uint32_t(i);
    result.add(double(s.sample(wo, sobol_owen(k, 1), van_der_corput_owen(k, 7), inside).weight.g));
  }
  return result;
}

TEST(Scattering, WhiteFurnaceOfMetalAndDielectric) {
  for (const float roughness : {0.0f, 0.1f, 0.3f, 0.6f, 1.0f})
    for (const float cosine : {0.1f, 0.3f, 0.6f, 0.99f}) {
      EXPECT_NEAR(albedo(Scattering(metal(roughness)), direction(cosine), false).mean(), 1, 0.01)
          << "metal " << roughness << " at " << cosine;
      EXPECT_NEAR(albedo(Scattering(dielectric(Rgb(1), roughness)), direction(cosine), false).mean(), 1, 0.01)
          << "dielectric " << roughness << " at " << cosine;
    }
}

TEST(Scattering, FacetsThatReflectEverythingLeaveNothingToTheBody) {
  for (const float roughness : {0.1f, 0.3f, 0.6f, 1.0f})
    for (const float cosine : {0.1f, 0.6f, 0.99f}) {
      Surface s = dielectric(Rgb(0.8f), roughness);
      s.specular_tint = Rgb(25.0f);  // F0 of index 1.5 is 0.04
      EXPECT_NEAR(albedo(Scattering(s), direction(cosine), false).mean(), 1, 0.01) << roughness << " at " << cosine;
    }
}

TEST(Scattering, NothingReflectsMoreThanItGets) {
  for (const float roughness : {0.0f, 0.05f, 0.2f, 0.5f, 0.8f, 1.0f})
    for (const float cosine : {0.02f, 0.2f, 0.5f, 0.8f, 1.0f})
      for (const bool inside : {false, true}) {
        const double whole = albedo(Scattering(glass(roughness)), direction(cosine), inside).mean();
        EXPECT_LT(whole, 1.02) << roughness << " at " << cosine << (inside ? " inside" : "");
        EXPECT_GT(whole, roughness < 0.3f ? 0.9 : 0.3) << "between rough clear facets light is lost";
        Surface mixed = glass(roughness);
        mixed.transmission = 0.4f, mixed.metallic = 0.3f, mixed.base = {0.9f, 0.5f, 0.1f};
        EXPECT_LT(albedo(Scattering(mixed), direction(cosine), inside).mean(), 1.01);
      }
}

TEST(Scattering, ClearSmoothGlassLosesNothing) {
  for (const float cosine : {0.05f, 0.4f, 0.9f})
    for (const bool inside : {false, true})
      EXPECT_NEAR(albedo(Scattering(glass(0)), direction(cosine), inside).mean(), 1, 1e-5);
}

TEST(Scattering, SampledDensityIsThatOfEval) {
  // Integrating eval over the sphere gives the mean weight of sample, and its density integrates to one.
  Surface mixed = dielectric({0.7f, 0.5f, 0.2f}, 0.5f);
  mixed.metallic = 0.3f, mixed.transmission = 0.5f;
  for (const Surface& surface : {dielectric(Rgb(0.5f), 0.6f), metal(0.4f), glass(0.5f), mixed})
    for (const bool inside : {false, true}) {
      const Scattering s(surface);
      const Vec3 wo = direction(0.6f);
      RunningStatistics value, density;
      for (uint32_t i = 0; i < 200000; ++i) {
        const Vec2 u = sobol_owen(i, 3);
        const float z = 1 - 2 * u.x, r = std::sqrt(1 - z * z), phi = float(2 * kPi) * u.y;
        const ScatterValue v = s.eval(wo, {r * std::cos(phi), r * std::sin(phi), z}, inside);
        value.add(double(v.value.g) * 4 * kPi), density.add(double(v.pdf) * 4 * kPi);
      }
      const RunningStatistics sampled = albedo(s, wo, inside, 100000);
      EXPECT_NEAR(value.mean(), sampled.mean(), 0.01) << surface.transmission << surface.metallic << inside;
      EXPECT_LT(density.mean(), 1.02);
      EXPECT_GT(density.mean(), 0.9) << "a few directions fall below the surface and are lost";
    }
}

TEST(Scattering, Reciprocal) {
  Surface mixed = dielectric({0.7f, 0.5f, 0.2f}, 0.5f);
  mixed.metallic = 0.3f;
  for (const Surface& surface : {dielectric(Rgb(0.5f), 0.6f), dielectric(Rgb(0.5f), 0), mixed}) {
    const Scattering s(surface);
    const Vec3 a = direction(0.3f), b = normalize(Vec3(-0.2f, 0.5f, 0.7f));
    const double forward = double(s.eval(a, b, false).value.g / b.z), back = double(s.eval(b, a, false).value.g / a.z);
    // The compensation of metal facets depends on one direction alone: within a tenth.
    EXPECT_NEAR(forward, back, (surface.metallic > 0 ? 0.1 : 1e-2) * forward);
  }
}

TEST(Scattering, MirrorAndRefractionAreExact) {
  const Scattering s(glass(0));
  EXPECT_TRUE(s.only_smooth());
  const Vec3 wo = direction(0.6f);
  const ScatterSample mirrored = s.sample(wo, {0.5f, 0.5f}, 0, false),
                      refracted = s.sample(wo, {0.5f, 0.5f}, 0.99f, false);
  EXPECT_EQ(mirrored.pdf, 0);
  EXPECT_NEAR(mirrored.wi.x, -wo.x, 1e-6);
  EXPECT_NEAR(refracted.wi.x, -wo.x / 1.5f, 1e-6);
  EXPECT_LT(refracted.wi.z, 0);
  EXPECT_EQ(s.eval(wo, mirrored.wi, false).pdf, 0);
  for (const float choice : {0.0f, 0.5f, 0.999f})  // beyond the critical angle everything is reflected
    EXPECT_GT(s.sample(direction(0.5f), {0.5f, 0.5f}, choice, true).wi.z, 0);
}

TEST(FacetAlbedo, SmoothFacetsReflectEverything) {
  for (const float cosine : {0.05f, 0.5f, 1.0f}) {
    const FacetAlbedo e = facet_albedo(0, cosine);
    EXPECT_NEAR(e.scale + e.bias, 1, 2e-3);
    EXPECT_NEAR(e.bias, std::pow(1 - cosine, 5), 1e-2);
  }
  EXPECT_LT(facet_albedo(1, 1).scale + facet_albedo(1, 1).bias, 0.7f);
}

}  // namespace
}  // namespace aktina
