#include "aktina/raster/shading/lin.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/random.h"

namespace aktina {
namespace {

float value(const Quadratics& q, float t) {
  const float(&c)[3] = t >= q.split ? q.right : q.left;
  return c[0] + t * (c[1] + t * c[2]);
}

TEST(LinShading, PeakIsTheHighestCosineOnTheSpan) {
  Pcg32 random(8);
  int peaks = 0;
  for (int round = 0; round < 300; ++round) {
    const auto direction = [&] { return normalize(Vec3(random.uniform() - 0.5f, random.uniform() - 0.5f, 0.6f)); };
    const Vec3 a = direction(), b = direction(), h = direction();
    const auto peak = span_peak(CombinedPair({{a, b}, {h, h}}));
    float best = -1, where = 0;
    for (float t = 0; t <= 1; t += 1.0f / 4096)
      if (const float c = dot(normalize(linear(a, b, t)), h); c > best) best = c, where = t;
    if (!peak) {
      EXPECT_NEAR(best, std::max(dot(a, h), dot(b, h)), 1e-5f);
      continue;
    }
    ++peaks;
    EXPECT_NEAR(peak->value, best, 1e-5f);
    EXPECT_NEAR(peak->t, where, 0.02f);
  }
  EXPECT_GT(peaks, 60);
}

TEST(LinShading, CurveMeetsEndsAndPeakAndIsLevelThere) {
  const SpanPeak peak{0.3f, 0.98f, 0.7f, 0.4f};
  const Quadratics q = peak_curve(peak);
  EXPECT_NEAR(value(q, 0), 0.7f, 1e-6f);
  EXPECT_NEAR(value(q, 1), 0.4f, 1e-6f);
  EXPECT_NEAR(value(q, 0.3f), 0.98f, 1e-6f);
  EXPECT_NEAR((value(q, 0.301f) - value(q, 0.299f)) / 0.002f, 0, 5e-3f);
  for (float t = 0; t <= 1; t += 0.01f) EXPECT_LE(value(q, t), 0.98f + 1e-6f);
}

}  // namespace
}  // namespace aktina
