#include "aktina/illumination/cook_torrance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "illumination/model_checks.h"

namespace aktina {
namespace {

TEST(CookTorrance, IsReciprocal) {
  const Surface s{.kd = Rgb(0.2f), .ks = Rgb(0.7f), .roughness = 0.6f, .ior = 1.8f};
  for (const float theta : {0.1f, 0.6f, 1.2f})
    for (const float phi : {0.5f, 2.0f, 3.1f}) {
      const Vec3 n(0, 0, 1), a = test::direction(0.7f, 0), b = test::direction(theta, phi);
      const float ab = CookTorrance{}.brdf(s, n, a, b).total().g, ba = CookTorrance{}.brdf(s, n, b, a).total().g;
      EXPECT_NEAR(ab, ba, 1e-4f * ab);
    }
}

TEST(CookTorrance, MirrorsFourTimesItsFresnelShare) {
  // As printed, with a D whose projected facets cover pi: the 4 of the change from facets to directions is missing.
  const Surface s{.kd = Rgb(0), .ks = Rgb(1), .ior = 1.5f};
  EXPECT_NEAR(test::albedo(CookTorrance{0.1f}, s, {0, 0, 1}, 1 << 16), 4 * 0.04, 2e-3);
}

TEST(CookTorrance, HighlightVanishesWithTheIndexStep) {
  const Surface s{.kd = Rgb(0.3f), .ks = Rgb(1), .ior = 1};
  const Reflectance f = CookTorrance{}.brdf(s, {0, 0, 1}, test::direction(0.3f, 0), test::direction(0.3f, 3));
  EXPECT_NEAR(f.total().g, 0.3f / float(kPi), 1e-6f);
}

}  // namespace
}  // namespace aktina
