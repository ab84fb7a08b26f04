#include "aktina/illumination/ggx.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/random.h"
#include "aktina/base/statistics.h"

namespace aktina {
namespace {

Vec3 direction(float theta, float phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// Integral over the hemisphere of f(w), by a midpoint rule in theta and phi.
template <class F>
double integrate(F f, int steps = 400) {
  Sum sum;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      // theta = x^2 pi / 2 crowds the points where narrow lobes are
      const double x = (i + 0.5) / steps, theta = x * x * kPi / 2, phi = 2 * kPi * (j + 0.5) / steps;
      sum.add(double(f(direction(float(theta), float(phi)))) * std::sin(theta) * x * kPi / steps * 2 * kPi / steps);
    }
  return sum.value();
}

TEST(Ggx, ProjectedFacetsCoverTheSurfaceOnce) {
  for (const float alpha : {0.02f, 0.1f, 0.5f, 1.0f})
    EXPECT_NEAR(integrate([&](Vec3 h) { return ggx_distribution(alpha, h) * h.z; }), 1, 2e-3) << alpha;
}

TEST(Ggx, FacetsThatAreSeenCoverTheViewOnce) {
  // Walter 2007, Heitz 2014: the integral of G1 D (wo.h)+ is wo.z.
  for (const float alpha : {0.1f, 0.5f, 1.0f})
    for (const float theta : {0.1f, 0.8f, 1.4f}) {
      const Vec3 wo = direction(theta, 0);
      const double seen = integrate(
          [&](Vec3 h) { return ggx_masking(alpha, wo.z) * ggx_distribution(alpha, h) * std::max(dot(wo, h), 0.0f); });
      EXPECT_NEAR(seen / wo.z, 1, 3e-3) << alpha << " " << theta;
    }
}

TEST(Ggx, SampledNormalsFollowTheirDensity) {
  // Chi-square over cells of (cosine, angle) of the half sphere of normals.
  constexpr int kRows = 8, kColumns = 12, kDraws = 200000, kFine = 24;
  for (const float alpha : {0.2f, 0.7f})
    for (const float theta : {0.2f, 1.2f}) {
      const Vec3 wo = direction(theta, 0.4f);
      const auto density = [&](Vec3 h) {
        return ggx_masking(alpha, wo.z) * ggx_distribution(alpha, h) * std::max(dot(wo, h), 0.0f) / wo.z;
      };
      double expected[kRows][kColumns] = {}, found[kRows][kColumns] = {};
      for (int i = 0; i < kRows * kFine; ++i)
        for (int j = 0; j < kColumns * kFine; ++j) {
          const float z = (float(i) + 0.5f) / (kRows * kFine),
                      phi = float(2 * kPi) * (float(j) + 0.5f) / (kColumns * kFine);
          const float r = std::sqrt(1 - z * z);
          expected[i / kFine][j / kFine] += double(density({r * std::cos(phi), r * std::sin(phi), z})) * kDraws * 2 *
                                            kPi / (kRows * kFine * kColumns * kFine);
        }
      Pcg32 random(5);
      for (int k = 0; k < kDraws; ++k) {
        const Vec3 h = sample_ggx_normal(alpha, wo, {random.uniform(), random.uniform()});
        ASSERT_NEAR(length(h), 1, 1e-5f);
        const double phi = std::atan2(h.y, h.x) + (h.y < 0 ? 2 * kPi : 0);
        ++found[std::min(int(h.z * kRows), kRows - 1)][std::min(int(phi / (2 * kPi) * kColumns), kColumns - 1)];
      }
      double chi2 = 0;
      int cells = 0;
      for (int i = 0; i < kRows; ++i)
        for (int j = 0; j < kColumns; ++j)
          if (expected[i][j] > 10) {
            chi2 += (found[i][j] - expected[i][j]) * (found[i][j] - expected[i][j]) / expected[i][j];
            ++cells;
          }
      EXPECT_LT(chi2, cells + 5 * std::sqrt(2.0 * cells)) << alpha << " " << theta << ": " << cells << " cells";
    }
}

TEST(Ggx, MetalReflectsNoMoreThanArrives) {
  Surface s;
  s.base = Rgb(1), s.metallic = 1;
  for (const float roughness : {0.3f, 0.6f, 1.0f})
    for (const float theta : {0.1f, 0.8f, 1.45f}) {
      s.roughness = roughness;
      const Vec3 wo = direction(theta, 0.3f);
      const double albedo = integrate([&](Vec3 wi) { return Ggx{}.brdf(s, {0, 0, 1}, wi, wo).total().g * wi.z; });
      EXPECT_LT(albedo, 1.002) << roughness << " " << theta;
      EXPECT_GT(albedo, 1 - 0.75 * double(roughness)) << roughness << " " << theta;
    }
}

TEST(Ggx, IsReciprocal) {
  Surface s;
  s.base = {0.9f, 0.5f, 0.2f}, s.metallic = 0.3f, s.roughness = 0.4f;
  Pcg32 random(2);
  for (int i = 0; i < 100; ++i) {
    const Vec3 n(0, 0, 1), a = direction(1.5f * random.uniform(), 6 * random.uniform());
    const Vec3 b = direction(1.5f * random.uniform(), 6 * random.uniform());
    const Rgb ab = Ggx{}.brdf(s, n, a, b).total(), ba = Ggx{}.brdf(s, n, b, a).total();
    EXPECT_NEAR(ab.g, ba.g, 1e-4f * ab.g);
  }
}

TEST(Ggx, LobeIntegratesToItsFresnelShareAtNormalIncidence) {
  // With F = 1 the lobe loses only what is masked: nothing for a smooth surface.
  Surface s;
  s.base = Rgb(1), s.metallic = 1, s.roughness = 0.2f;
  const double albedo = integrate([&](Vec3 wi) { return Ggx{}.brdf(s, {0, 0, 1}, wi, {0, 0, 1}).total().g * wi.z; });
  EXPECT_NEAR(albedo, 1, 3e-3);
}

}  // namespace
}  // namespace aktina
