#include "aktina/radiosity/mesher/junctions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "aktina/base/random.h"

namespace aktina {
namespace {

TEST(Junctions, FindsAllPointsOnAnEdgeInTheirOrderAndNoOthers) {
  Pcg32 random(5);
  const auto point = [&] { return Point3(random.uniform(), random.uniform(), random.uniform()); };
  std::vector<Point3> points;
  for (int i = 0; i < 3000; ++i) points.push_back(point());
  for (int trial = 0; trial < 50; ++trial) {
    Point3 a = point(), b = point();
    for (int k = 0; k < trial % 3; ++k) b[(trial + k) % 3] = a[(trial + k) % 3];  // along an axis, too
    std::vector<float> at = {0.2f, 0.31f, 0.5f, 0.9f};
    std::vector<Point3> all = points;
    for (const float t : at) all.push_back(a + (b - a) * t);
    all.insert(all.end(), {a, b, all[3000], all[3001] + Vec3(0.01f, 0.01f, 0.01f)});
    const Junctions junctions(all);
    std::vector<Point3> found;
    junctions.on_edge(a, b, found);
    ASSERT_EQ(found, std::vector<Point3>(all.begin() + 3000, all.begin() + 3004)) << trial;
    junctions.on_edge(b, a, found);
    std::reverse(found.begin(), found.end());
    EXPECT_EQ(found, std::vector<Point3>(all.begin() + 3000, all.begin() + 3004));
  }
}

}  // namespace
}  // namespace aktina
