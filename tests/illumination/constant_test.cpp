#include "aktina/illumination/constant.h"

#include <gtest/gtest.h>

#include "illumination/model_checks.h"

namespace aktina {
namespace {

TEST(Constant, ShinesFromTheViewerWhereverTheLampStands) {
  const Surface s{.kd = Rgb(0.5f)};
  const Vec3 n(0, 0, 1), wo = test::direction(0.6f, 1);
  for (const float theta : {0.0f, 1.0f, 2.5f})  // in front, beside, behind
    EXPECT_NEAR(classic_radiance(Constant{}, s, n, test::direction(theta, 2), wo, Rgb(2)).g, 2 * 0.5f * std::cos(0.6f),
                1e-6f);
}

TEST(Constant, LeavesOutHighlights) {
  const Surface s{.kd = Rgb(0), .ks = Rgb(1), .exponent = 2};
  EXPECT_TRUE(is_black(classic_radiance(Constant{}, s, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, Rgb(1))));
}

}  // namespace
}  // namespace aktina
