#include <gtest/gtest.h>

#include "illumination/model_checks.h"

namespace aktina {
namespace {

const Vec3 kNormal(0, 0, 1);

TEST(Lambert, ReflectsItsCoefficientInAWhiteFurnace) {
  const Surface s{.kd = Rgb(0.7f), .ks = Rgb(0.5f)};
  for (const float theta : {0.0f, 0.8f, 1.5f})
    EXPECT_NEAR(test::albedo(Lambert{}, s, test::direction(theta, 0), 1024), 0.7, 1e-5) << "ks plays no part";
}

TEST(Lambert, DoesNotContainTheCosine) {
  const Surface s{.kd = Rgb(0.6f)};
  const Rgb steep = brdf(Lambert{}, s, kNormal, kNormal, kNormal).total();
  const Rgb grazing = brdf(Lambert{}, s, kNormal, test::direction(1.5f, 1), kNormal).total();
  EXPECT_EQ(steep, grazing);
  EXPECT_FLOAT_EQ(steep.g, 0.6f / float(kPi));
}

}  // namespace
}  // namespace aktina
