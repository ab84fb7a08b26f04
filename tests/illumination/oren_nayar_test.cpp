#include "aktina/illumination/oren_nayar.h"

#include <gtest/gtest.h>

#include <cmath>

#include "illumination/model_checks.h"

namespace aktina {
namespace {

const Vec3 kNormal(0, 0, 1);

TEST(OrenNayar, WithoutRoughnessIsLambert) {
  const Surface s{.kd = Rgb(0.6f)};
  const Vec3 wi = test::direction(0.8f, 1), wo = test::direction(1.1f, 2);
  EXPECT_FLOAT_EQ(OrenNayar{0}.brdf(s, kNormal, wi, wo).total().g, 0.6f / float(kPi));
}

TEST(OrenNayar, FollowsItsEquation) {
  // eq. 30 with sigma = 0.5: A = 1 - 0.5 * 0.25 / 0.58, B = 0.45 * 0.25 / 0.34
  const double a = 1 - 0.5 * 0.25 / 0.58, b = 0.45 * 0.25 / 0.34;
  const Surface s{.kd = Rgb(1)};
  for (const double phi : {0.0, 0.7, 2.5}) {
    const Vec3 wi = test::direction(1.0f, 0), wo = test::direction(0.4f, float(phi));
    const double f = (a + b * std::max(0.0, std::cos(phi)) * std::sin(1.0) * std::tan(0.4)) / kPi;
    EXPECT_NEAR(OrenNayar{0.5f}.brdf(s, kNormal, wi, wo).total().g, f, 1e-6);
    EXPECT_NEAR(OrenNayar{0.5f}.brdf(s, kNormal, wo, wi).total().g, f, 1e-6) << "reciprocal";
  }
}

TEST(OrenNayar, ReturnsLightTowardsItsSource) {
  const Surface s{.kd = Rgb(1)};
  const Vec3 wi = test::direction(1.2f, 0);
  const float back = OrenNayar{0.6f}.brdf(s, kNormal, wi, wi).total().g;
  const float forth = OrenNayar{0.6f}.brdf(s, kNormal, wi, test::direction(1.2f, float(kPi))).total().g;
  EXPECT_GT(back, 1.5f * forth);
}

TEST(OrenNayar, ReflectsNoMoreThanArrives) {
  for (const float sigma : {0.0f, 0.3f, 0.8f, 1.5f})
    for (const float theta : {0.0f, 0.7f, 1.5f})
      EXPECT_LE(test::albedo(OrenNayar{sigma}, {.kd = Rgb(1)}, test::direction(theta, 0), 4096), 1.001);
}

}  // namespace
}  // namespace aktina
