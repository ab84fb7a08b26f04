#include "aktina/base/random.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

namespace aktina {
namespace {

// A (0, 2)-sequence puts exactly one of any 2^m aligned points into each elementary interval of area 2^-m.
TEST(SobolOwen, FirstPowerOfTwoPointsFillEveryElementaryInterval) {
  EXPECT_TRUE(rc::check([] {
    const auto seed = *rc::gen::arbitrary<uint32_t>();
    const int m = *rc::gen::inRange(0, 9), log_columns = *rc::gen::inRange(0, m + 1);
    const int columns = 1 << log_columns, rows = 1 << (m - log_columns);
    std::set<std::pair<int, int>> cells;
    for (uint32_t i = 0; i < (1U << m); ++i) {
      const Vec2 p = sobol_owen(i, seed);
      cells.emplace(int(p.x * float(columns)), int(p.y * float(rows)));
    }
    RC_ASSERT(cells.size() == size_t(1) << m);
  }));
}

TEST(SobolOwen, SeedsGiveIndependentPoints) {
  double correlation = 0;
  constexpr int kSeeds = 4000;
  for (uint32_t seed = 0; seed < kSeeds; ++seed)
    correlation += double(sobol_owen(0, seed).x - 0.5f) * double(sobol_owen(0, seed + 1).x - 0.5f);
  EXPECT_NEAR(correlation / kSeeds, 0, 4.0 / 12 / std::sqrt(double(kSeeds)));  // 4 standard errors of a product of two
}

TEST(VanDerCorput, StratifiesPowersOfTwo) {
  for (uint32_t seed = 0; seed < 50; ++seed) {
    std::set<int> cells;
    for (uint32_t i = 0; i < 64; ++i) cells.insert(int(van_der_corput_owen(i, seed) * 64));
    EXPECT_EQ(cells.size(), 64U);
  }
}

TEST(Pcg32, IsUniform) {
  Pcg32 random(1);
  double sum = 0, squares = 0;
  constexpr int kDraws = 1 << 20;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.uniform_double();
    ASSERT_GE(x, 0);
    ASSERT_LT(x, 1);
    sum += x, squares += x * x;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 4 * std::sqrt(1.0 / 12 / kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / kDraws));
}

TEST(CosineHemisphere, MeanCosineIsTwoThirds) {
  double sum = 0;
  constexpr int kDraws = 1 << 14;
  for (uint32_t i = 0; i < kDraws; ++i) {
    const Vec3 w = sample_cosine_hemisphere(sobol_owen(i, 7));
    ASSERT_NEAR(length(w), 1, 1e-6);
    sum += w.z;
  }
  EXPECT_NEAR(sum / kDraws, 2.0 / 3, 1e-4);
}

}  // namespace
}  // namespace aktina
