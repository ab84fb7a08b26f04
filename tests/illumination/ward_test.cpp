#include "aktina/illumination/ward.h"

#include <gtest/gtest.h>

#include <cmath>

#include "illumination/model_checks.h"

namespace aktina {
namespace {

TEST(Ward, IsReciprocal) {
  const Surface s{.kd = Rgb(0.1f), .ks = Rgb(0.5f)};
  const Ward model{0.1f, 0.4f};
  for (const float theta : {0.2f, 0.9f, 1.3f}) {
    const Vec3 n(0, 0, 1), a = test::direction(0.7f, 0.3f), b = test::direction(theta, 2.8f);
    const float ab = model.brdf(s, n, a, b).total().g;
    EXPECT_NEAR(ab, model.brdf(s, n, b, a).total().g, 1e-5f * ab);
  }
}

TEST(Ward, HighlightHoldsKsAtNormalIncidenceButForThreeSlopesSquared) {
  // With u = tan^2 of the facet angle, distributed as exp(-u / a^2) / a^2: the albedo is the mean of
  // sqrt((1 - u) / (1 + u)) / (1 + u)^2 = 1 - 3 u + O(u^2), so 1 - 3 a^2 + O(a^4).
  for (const float slope : {0.05f, 0.1f, 0.2f}) {
    const double a2 = double(slope) * double(slope);
    EXPECT_NEAR(test::albedo(Ward{slope, slope}, {.kd = Rgb(0), .ks = Rgb(1)}, {0, 0, 1}, 1 << 16), 1 - 3 * a2,
                14 * a2 * a2 + 1e-3)
        << slope;
  }
}

TEST(Ward, EqualSlopesDoNotKnowTheDirectionOfScratches) {
  const Surface s{.kd = Rgb(0), .ks = Rgb(1)};
  const Vec3 n(0, 0, 1);
  const float f = Ward{0.3f, 0.3f}.brdf(s, n, test::direction(0.5f, 0), test::direction(0.9f, 2)).specular.g;
  for (const float turn : {0.4f, 1.3f, 3.0f})
    EXPECT_NEAR(Ward({0.3f, 0.3f}).brdf(s, n, test::direction(0.5f, turn), test::direction(0.9f, 2 + turn)).specular.g,
                f, 1e-4f * f);
}

TEST(Ward, AQuarterTurnExchangesTheSlopes) {
  const Surface s{.kd = Rgb(0), .ks = Rgb(1)};
  const Vec3 n(0, 0, 1);
  const float quarter = float(kPi / 2);
  const float f = Ward{0.1f, 0.4f}.brdf(s, n, test::direction(0.5f, 0.3f), test::direction(0.7f, 3)).specular.g;
  const float turned =
      Ward{0.4f, 0.1f}.brdf(s, n, test::direction(0.5f, 0.3f + quarter), test::direction(0.7f, 3 + quarter)).specular.g;
  EXPECT_NEAR(turned, f, 1e-3f * f);
}

TEST(Ward, HighlightIsWiderAcrossTheScratches) {
  // n along z: scratches run along x.
  const Surface s{.kd = Rgb(0), .ks = Rgb(1)};
  const Vec3 n(0, 0, 1), wi(0, 0, 1);
  const Ward brushed{0.05f, 0.3f};
  EXPECT_GT(brushed.brdf(s, n, wi, test::direction(0.5f, float(kPi / 2))).specular.g,
            100 * brushed.brdf(s, n, wi, test::direction(0.5f, 0)).specular.g);
}

}  // namespace
}  // namespace aktina
