#include <gtest/gtest.h>

#include "illumination/model_checks.h"

namespace aktina {
namespace {

const Vec3 kNormal(0, 0, 1);

TEST(BlinnPhong, HighlightIsAPowerOfTheCosineOfTheHalfVector) {
  // Light at 0.5 and viewer at 0.5 + off on the other side: the half vector leans off / 2 from the normal.
  for (const float off : {0.0f, 0.2f, 0.6f})
    EXPECT_NEAR(blinn_highlight(kNormal, test::direction(0.5f, 0), test::direction(0.5f + off, float(kPi)), 20),
                std::pow(std::cos(off / 2), 20.0f), 1e-5f);
}

TEST(BlinnPhong, FourTimesTheExponentGivesPhongsWidth) {
  const Vec3 wi = test::direction(0.3f, 0);
  for (const float off : {0.05f, 0.1f, 0.15f}) {
    const Vec3 wo = test::direction(0.3f + off, float(kPi));
    EXPECT_NEAR(blinn_highlight(kNormal, wi, wo, 400), phong_highlight(kNormal, wi, wo, 100), 0.02f);
  }
}

TEST(BlinnPhong, WithoutHighlightIsLambert) {
  const Surface s{.kd = Rgb(0.4f)};
  EXPECT_NEAR(test::albedo(BlinnPhong{}, s, test::direction(0.3f, 0), 1024), 0.4, 1e-5);
}

TEST(BlinnPhong, OpposedLightAndViewerAreFinite) {
  EXPECT_TRUE(is_finite(brdf(BlinnPhong{}, Surface{.ks = Rgb(1)}, kNormal, Vec3(1, 0, 0), Vec3(-1, 0, 0)).total()));
}

}  // namespace
}  // namespace aktina
