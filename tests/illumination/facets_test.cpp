#include "aktina/illumination/facets.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "illumination/model_checks.h"

namespace aktina {
namespace {

TEST(Facets, DistributionsAreOneAlongTheNormalAndHalfAtTheirWidth) {
  for (const float beta : {0.05f, 0.3f, 0.7f, 1.2f}) {
    const FacetWidths width = facet_widths(beta);
    EXPECT_EQ(facet_phong(0, width.c1), 1);
    EXPECT_EQ(facet_gaussian(0, width.c2), 1);
    EXPECT_NEAR(facet_trowbridge_reitz(0, width.c3), 1, 1e-6f);
    EXPECT_NEAR(facet_phong(beta, width.c1), 0.5f, 1e-4f);
    EXPECT_NEAR(facet_gaussian(beta, width.c2), 0.5f, 1e-5f);
    EXPECT_NEAR(facet_trowbridge_reitz(beta, width.c3), 0.5f, 1e-4f);
  }
}

TEST(Facets, ProjectedBeckmannFacetsCoverPi) {
  for (const float m : {0.1f, 0.3f, 0.8f}) {
    double sum = 0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      const double alpha = (i + 0.5) / kSteps * kPi / 2;
      sum += double(facet_beckmann(float(alpha), m)) * std::cos(alpha) * std::sin(alpha) * 2 * kPi * (kPi / 2 / kSteps);
    }
    EXPECT_NEAR(sum, kPi, 2e-3) << m;
  }
}

TEST(Facets, FresnelAtItsKnownAngles) {
  EXPECT_NEAR(fresnel_dielectric(1, 1.5f), 0.04f, 1e-6f);                               // ((eta - 1) / (eta + 1))^2
  EXPECT_NEAR(fresnel_dielectric(std::cos(std::atan(1.5f)), 1.5f), 0.0739645f, 1e-5f);  // Brewster: half of Rs alone
  EXPECT_NEAR(fresnel_dielectric(0, 1.5f), 1, 1e-6f);
  EXPECT_EQ(fresnel_dielectric(0.5f, 1 / 1.5f), 1);  // beyond the critical angle of 41.8 degrees
  EXPECT_EQ(fresnel_dielectric(1, 1), 0);
}

TEST(Facets, FresnelIsTheSameFromBothSides) {
  EXPECT_TRUE(rc::check([] {  // Snell: reflectances of the two directions of one path are equal
    const float cosine = 0.01f * float(*rc::gen::inRange(2, 100)), eta = 1 + 0.01f * float(*rc::gen::inRange(1, 150));
    const float sine = std::sqrt(1 - cosine * cosine) / eta;
    RC_ASSERT(std::abs(fresnel_dielectric(cosine, eta) - fresnel_dielectric(std::sqrt(1 - sine * sine), 1 / eta)) <
              2e-4f);
  }));
}

TEST(Facets, MaskingIsAShareAndReciprocal) {
  EXPECT_TRUE(rc::check([] {
    const auto direction = [] {
      return test::direction(0.015f * float(*rc::gen::inRange(0, 104)), 0.01f * float(*rc::gen::inRange(0, 628)));
    };
    const Vec3 n(0, 0, 1), a = direction(), b = direction();
    const float g = groove_masking(n, a, b);
    RC_ASSERT(g >= 0 && g <= 1);
    RC_ASSERT(std::abs(g - groove_masking(n, b, a)) < 1e-5f);
    RC_ASSERT(std::abs(groove_masking_over_view(n, a, b) * b.z - g) < 1e-4f);
  }));
  // half of the light along the normal, where the viewer sees facets of 60 degrees: 2 (n.h)(n.v) / (v.h)
  const Vec3 wi = test::direction(0, 0), wo = test::direction(1.4f, 0);
  EXPECT_NEAR(groove_masking({0, 0, 1}, wi, wo), 2 * std::cos(1.4f), 1e-5f);
}

}  // namespace
}  // namespace aktina
