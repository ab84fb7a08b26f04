#include <gtest/gtest.h>

#include "aktina/illumination/facets.h"
#include "illumination/model_checks.h"

namespace aktina {
namespace {

const Vec3 kNormal(0, 0, 1);

TEST(Phong, HighlightIsAPowerOfTheCosineFromTheMirrorDirection) {
  for (const float off : {0.0f, 0.1f, 0.4f}) {
    const Vec3 wi = test::direction(0.5f, 0), wo = test::direction(0.5f + off, float(kPi));
    EXPECT_NEAR(phong_highlight(kNormal, wi, wo, 20), std::pow(std::cos(off), 20.0f), 1e-5f);
  }
  EXPECT_EQ(reflect_about(kNormal, test::direction(0.5f, 0)).z, std::cos(0.5f));
}

TEST(Phong, RadianceOfTheClassicEquation) {
  // L = (E / pi) (kd n.wi + ks (r.wo)^n): the light's colour of the classic equation is E / pi.
  const Surface s{.kd = Rgb(0.3f), .ks = Rgb(0.6f), .exponent = 10};
  const Vec3 wi = test::direction(0.7f, 0), wo = test::direction(0.6f, float(kPi));
  const float n_wi = std::cos(0.7f), classic = 0.3f * n_wi + 0.6f * std::pow(std::cos(0.1f), 10.0f);
  EXPECT_NEAR(brdf(Phong{}, s, kNormal, wi, wo).total().g * n_wi * float(kPi), classic, 1e-5f);
}

TEST(Phong, WithoutHighlightIsLambert) {
  const Surface s{.kd = Rgb(0.4f)};
  EXPECT_NEAR(test::albedo(Phong{}, s, test::direction(0.3f, 0), 1024), 0.4, 1e-5);
}

TEST(Phong, FresnelWeightGrowsTowardsGrazingIncidence) {
  const Surface s{.ks = Rgb(1), .exponent = 30};
  for (const float theta : {0.0f, 0.5f, 1.4f}) {
    const Vec3 wi = test::direction(theta, 0), wo = test::direction(theta, float(kPi));
    EXPECT_NEAR(Phong{true}.highlight(s, kNormal, wi, wo), fresnel_dielectric(std::cos(theta), 1.5f), 1e-4f);
  }
}

TEST(Phong, HighlightIsNotReciprocal) {
  // A property of the model, stated in its file: f changes when light and viewer change places.
  const Surface s{.kd = Rgb(0), .ks = Rgb(0.5f), .exponent = 4};
  const Vec3 a = test::direction(0.2f, 0), b = test::direction(1.0f, float(kPi));
  EXPECT_GT(std::abs(brdf(Phong{}, s, kNormal, a, b).total().g - brdf(Phong{}, s, kNormal, b, a).total().g), 0.01f);
}

}  // namespace
}  // namespace aktina
