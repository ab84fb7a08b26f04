#include "aktina/radiosity/lightmap/flat_overlap.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

namespace aktina {
namespace {

TEST(FlatOverlap, NeighboursDoNotOverlap) {
  const std::vector<FlatTriangle> triangles = {
      {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}, {Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}, {Vec2(1, 1), Vec2(2, 1), Vec2(2, 2)}};
  EXPECT_EQ(flat_overlap(triangles).count, 0u);
}

TEST(FlatOverlap, TheLaterOfTwoIsNamed) {
  const std::vector<FlatTriangle> triangles = {{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)},
                                               {Vec2(5, 5), Vec2(6, 5), Vec2(5, 6)},
                                               {Vec2(0.2f, 0.2f), Vec2(0.2f, 2), Vec2(2, 0.2f)}};  // clockwise
  const FlatOverlap overlap = flat_overlap(triangles);
  EXPECT_EQ(overlap.count, 1u);
  EXPECT_EQ(overlap.upon, (std::vector<uint8_t>{0, 0, 1}));
}

TEST(FlatOverlap, OneWithinTheOtherAndTheSameTwice) {
  EXPECT_EQ(flat_overlap(
                std::vector<FlatTriangle>{{Vec2(0, 0), Vec2(9, 0), Vec2(0, 9)}, {Vec2(1, 1), Vec2(2, 1), Vec2(1, 2)}})
                .count,
            1u);
  EXPECT_EQ(flat_overlap(std::vector<FlatTriangle>(2, {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)})).count, 1u);
}

/// Whether a point lies within both, by sampling: nothing of the method under test.
bool sampled(const FlatTriangle& a, const FlatTriangle& b) {
  const auto inside = [](const FlatTriangle& t, Vec2 p) {
    float signs[3];
    for (size_t k = 0; k < 3; ++k) {
      const Vec2 e = t[(k + 1) % 3] - t[k], d = p - t[k];
      signs[k] = e.x * d.y - e.y * d.x;
    }
    return (signs[0] > 0 && signs[1] > 0 && signs[2] > 0) || (signs[0] < 0 && signs[1] < 0 && signs[2] < 0);
  };
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      const float u = (float(x) + 0.5f) / 128, v = (float(y) + 0.5f) / 128;
      if (u + v < 1 && inside(b, a[0] + u * (a[1] - a[0]) + v * (a[2] - a[0]))) return true;
    }
  return false;
}

RC_GTEST_PROP(FlatOverlap, FindsWhatSamplingFinds, ()) {
  const auto coordinate = [] { return float(*rc::gen::inRange(0, 9)); };
  FlatTriangle a, b;
  for (FlatTriangle* const t : {&a, &b})
    for (Vec2& p : *t) p = {coordinate(), coordinate()};
  RC_PRE(twice_area(a) != 0 && twice_area(b) != 0);
  const bool found = flat_overlap(std::vector<FlatTriangle>{a, b}).count > 0;
  if (sampled(a, b)) RC_ASSERT(found);
  if (!found) RC_ASSERT(!sampled(b, a));
}

TEST(FlatOverlap, ManyNeedlesInOnePlaceAreNotCompared) {
  std::vector<FlatTriangle> needles;
  for (int i = 0; i < 8000; ++i) needles.push_back({Vec2(0, 0), Vec2(1, float(i)), Vec2(1, float(i) + 0.5f)});
  const FlatOverlap overlap = flat_overlap(needles);
  EXPECT_TRUE(!overlap.known || overlap.count == 0);
}

}  // namespace
}  // namespace aktina
