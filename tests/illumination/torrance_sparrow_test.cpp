#include "aktina/illumination/torrance_sparrow.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "illumination/model_checks.h"

namespace aktina {
namespace {

const Vec3 kNormal(0, 0, 1);

TEST(TorranceSparrow, IsReciprocal) {
  EXPECT_TRUE(rc::check([] {  // s(l, v) / (n.l) = s(v, l) / (n.v)
    const auto direction = [] {
      return test::direction(0.015f * float(*rc::gen::inRange(0, 100)), 0.01f * float(*rc::gen::inRange(0, 628)));
    };
    const Vec3 a = direction(), b = direction();
    const Surface s{.exponent = float(*rc::gen::inRange(1, 50)), .ior = 1.6f};
    for (const auto d : {FacetDistribution::phong, FacetDistribution::gaussian, FacetDistribution::trowbridge_reitz,
                         FacetDistribution::beckmann}) {
      const TorranceSparrow model{d};
      const float ab = model.highlight(s, kNormal, a, b) / a.z, ba = model.highlight(s, kNormal, b, a) / b.z;
      RC_ASSERT(std::abs(ab - ba) <= 1e-3f * (ab + 1e-3f));
    }
  }));
}

/// Angle in the plane of incidence where the highlight is brightest, degrees.
float peak_angle(const TorranceSparrow& model, const Surface& s, float incidence) {
  const Vec3 wi = test::direction(incidence * float(kPi) / 180, float(kPi));
  float best = 0, angle = 0;
  for (int k = 0; k < 1799; ++k) {
    const float degrees = 0.05f * float(k);
    const float value = model.highlight(s, kNormal, wi, test::direction(degrees * float(kPi) / 180, 0));
    if (value > best) best = value, angle = degrees;
  }
  return angle;
}

TEST(TorranceSparrow, PeaksBeyondTheMirrorDirectionForGrazingLight) {
  // The paper's off-specular peak, computed independently: Gaussian facets of 10 degrees, index 10.
  const TorranceSparrow model{FacetDistribution::gaussian, 10 * float(kPi) / 180};
  const Surface s{.ior = 10};
  const float incidence[] = {15, 30, 45, 60, 70}, peak[] = {16.5f, 33.2f, 50.9f, 80.0f, 83.4f};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(peak_angle(model, s, incidence[i]), peak[i], 0.11f) << incidence[i];
}

TEST(TorranceSparrow, StaysFiniteWhereTheViewerGrazes) {
  const Surface s{.exponent = 1};
  for (const float theta : {1.5f, 1.57f, 1.570796f}) {
    const float value = TorranceSparrow{}.highlight(s, kNormal, test::direction(1.2f, 0), test::direction(theta, 3));
    EXPECT_TRUE(std::isfinite(value));
    EXPECT_LE(value, 10);
  }
}

}  // namespace
}  // namespace aktina
