#include <gtest/gtest.h>

#include "aktina/illumination/light/light.h"

namespace aktina {
namespace {

TEST(DirectionalLight, IsTheSameEverywhere) {
  const Vec3 down = normalize(Vec3(1, -2, 0.5f));
  const DirectionalLight sun{.direction = down, .e_perp = Irradiance(Rgb(100000))};
  for (const Point3 x : {Point3(0), Point3(1e6f, -3, 7)}) {
    const LightSample s = sample(sun, x);
    EXPECT_EQ(s.wi, -down);
    EXPECT_EQ(s.distance, kInfinity);
    EXPECT_EQ(s.e_perp.v.g, 100000);
  }
  EXPECT_FALSE(flux(sun).has_value()) << "a light at infinity has no total";
}

}  // namespace
}  // namespace aktina
