#include "aktina/illumination/schlick.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "illumination/model_checks.h"

namespace aktina {
namespace {

TEST(Schlick, ReplacesThePowerWithTheSameEndsAndSlope) {
  for (const float n : {1.0f, 2.0f, 10.0f, 100.0f}) {
    EXPECT_EQ(schlick_power(0, n), 0);
    EXPECT_FLOAT_EQ(schlick_power(1, n), 1);
    const float h = 1e-3f / n;
    EXPECT_NEAR((1 - schlick_power(1 - h, n)) / h, n, 0.02f * n);
  }
}

TEST(Schlick, IsNeverBelowThePower) {
  EXPECT_TRUE(rc::check([] {  // Bernoulli
    const float t = 0.001f * float(*rc::gen::inRange(0, 1001)), n = float(*rc::gen::inRange(1, 500));
    RC_ASSERT(schlick_power(t, n) >= std::pow(t, n) - 1e-6f);
  }));
}

TEST(Schlick, LargestErrorsAreAsKnown) {
  const float exponent[] = {2, 5, 10, 50, 100}, largest[] = {0.090f, 0.155f, 0.179f, 0.199f, 0.201f};
  for (int k = 0; k < 5; ++k) {
    float worst = 0;
    for (int i = 0; i <= 10000; ++i) {
      const float t = float(i) / 10000;
      worst = std::max(worst, schlick_power(t, exponent[k]) - std::pow(t, exponent[k]));
    }
    EXPECT_NEAR(worst, largest[k], 6e-4f) << exponent[k];
  }
}

TEST(Schlick, FollowsTheMirrorDirectionOrTheHalfVector) {
  const Surface s{.exponent = 7};
  const Vec3 n(0, 0, 1), wi = test::direction(0.4f, 0), wo = test::direction(0.9f, float(kPi));
  EXPECT_NEAR(Schlick{false}.highlight(s, n, wi, wo), schlick_power(std::cos(0.5f), 7), 1e-5f);
  EXPECT_NEAR(Schlick{true}.highlight(s, n, wi, wo), schlick_power(std::cos(0.25f), 7), 1e-5f);
}

}  // namespace
}  // namespace aktina
