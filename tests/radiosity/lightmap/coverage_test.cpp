#include "aktina/radiosity/lightmap/coverage.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <cmath>

namespace aktina {
namespace {

LightmapLayout one_triangle(const FlatTriangle& t, int size = 16) {
  LightmapLayout layout;
  layout.pages = {{size, size}};
  PlacedChart chart;
  chart.width = chart.height = size;
  chart.triangles = {0}, chart.texels = {t};
  layout.charts.push_back(chart);
  return layout;
}

/// Squared distance of p to a triangle, by brute force.
double distance_to(const FlatTriangle& t, Vec2 p) {
  double best = 1e30;
  constexpr int kSteps = 400;
  for (int a = 0; a <= kSteps; ++a)
    for (int b = 0; b <= kSteps - a; ++b) {
      const float u = float(a) / kSteps, v = float(b) / kSteps;
      const Vec2 d = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]) - p;
      best = std::min(best, double(dot(d, d)));
    }
  return std::sqrt(best);
}

TEST(Coverage, EveryTouchedTexelOnceWithTheNearestPoint) {
  const FlatTriangle t = {Vec2(2.3f, 3.1f), Vec2(12.7f, 5.2f), Vec2(6.4f, 13.9f)};
  std::vector<uint8_t> covered(256, 0);
  for (const LightmapTexel& texel : covered_texels(one_triangle(t))) {
    EXPECT_EQ(covered[texel.y * 16 + texel.x]++, 0);
    const Vec2 middle(float(texel.x) + 0.5f, float(texel.y) + 0.5f);
    const Vec2 at = t[0] + texel.u * (t[1] - t[0]) + texel.v * (t[2] - t[0]);
    EXPECT_NEAR(length(at - middle), distance_to(t, middle), 0.03);
  }
  for (int y = 0; y < 16; ++y)  // points of the triangle lie in covered texels only
    for (int k = 0; k < 4000; ++k) {
      const auto row = k / 64;
      const float u = float(k % 64) / 63, v = float(row) / 62;
      if (u + v > 1) continue;
      const Vec2 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
      EXPECT_TRUE(int(p.y) != y || covered[size_t(p.y) * 16 + size_t(p.x)]) << p.x << " " << p.y;
    }
}

RC_GTEST_PROP(Coverage, NearestPointLiesOnTheTriangle, ()) {
  const auto coordinate = [] { return float(*rc::gen::inRange(0, 200)) / 10; };
  FlatTriangle t;
  for (Vec2& p : t) p = {coordinate(), coordinate()};
  const Vec2 p(coordinate(), coordinate()), uv = nearest_on_triangle(t, p);
  RC_ASSERT(uv.x >= 0 && uv.y >= 0 && uv.x + uv.y <= 1.00001f);
  const float own = length(t[0] + uv.x * (t[1] - t[0]) + uv.y * (t[2] - t[0]) - p);
  for (const Vec2 corner : t) RC_ASSERT(own <= length(corner - p) + 1e-3f);
}

TEST(Coverage, AChartSmallerThanATexelHasOne) {
  EXPECT_EQ(covered_texels(one_triangle({Vec2(4.4f, 4.4f), Vec2(4.5f, 4.4f), Vec2(4.4f, 4.5f)})).size(), 1u);
  EXPECT_GE(covered_texels(one_triangle({Vec2(4.5f, 4.5f), Vec2(4.5f, 4.5f), Vec2(4.5f, 4.5f)})).size(), 1u);
}

TEST(Spread, ReachesAllFromTheNearest) {
  Image image(20, 9, 3);
  std::vector<uint8_t> known(20 * 9, 0);
  for (int y = 0; y < 9; ++y)
    for (const int x : {2, 17}) image.set_rgb(x, y, Rgb(float(x))), known[size_t(y) * 20 + size_t(x)] = 1;
  spread(image, known);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 20; ++x) EXPECT_EQ(image.rgb(x, y), Rgb(x < 10 ? 2.0f : 17.0f)) << x;
}

TEST(Spread, UselessValuesAreReplacedFromTheirChartOnly) {
  LightmapLayout layout;
  layout.pages = {{8, 1}};
  layout.charts.resize(3);
  std::vector<LightmapTexel> texels;
  for (uint32_t x = 0; x < 8; ++x) texels.push_back({x < 4 ? 0u : x < 6 ? 1u : 2u, 0, x, 0, 0, 0});
  std::vector<Rgb> values;
  for (int x = 0; x < 8; ++x) values.emplace_back(float(x));
  replace_useless(layout, texels, {0, 0, 1, 1, 1, 1, 0, 0}, values);
  const float expected[] = {0, 1, 1, 1, 4, 5, 6, 7};  // the second chart has nothing better
  for (size_t x = 0; x < 8; ++x) EXPECT_EQ(values[x], Rgb(expected[x])) << x;
}

}  // namespace
}  // namespace aktina
