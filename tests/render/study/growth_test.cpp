#include "aktina/render/study/growth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/scene/mesh_check.h"
#include "render/study/scenes.h"

namespace aktina {
namespace {

TEST(StudyGrowth, SlopeOfAPower) {
  const std::vector<double> x = {10, 40, 160}, y = {3 * 100, 3 * 1600, 3 * 25600};
  EXPECT_NEAR(log_log_slope(x, y), 2, 1e-12);
}

TEST(StudyGrowth, SlopeNeedsTwoPointsThatHaveLogarithms) {
  EXPECT_TRUE(std::isnan(log_log_slope(std::vector<double>{10}, std::vector<double>{1})));
  EXPECT_TRUE(std::isnan(log_log_slope(std::vector<double>{10, 20}, std::vector<double>{0, 0})));
  EXPECT_TRUE(std::isnan(log_log_slope(std::vector<double>{10, 10}, std::vector<double>{1, 2})));
  EXPECT_TRUE(std::isnan(log_log_slope(std::vector<double>{10, 20}, std::vector<double>{kNotMeasured, 2})));
}

TEST(StudyGrowth, SubdivisionKeepsTheSurface) {
  const Scene coarse = test::ball(), fine = subdivided(coarse);
  const Mesh &a = coarse.meshes[0], &b = fine.meshes[0];
  EXPECT_EQ(b.triangles.size(), 4 * a.triangles.size());
  const MeshCheck before = check_mesh(a.positions, a.triangles), after = check_mesh(b.positions, b.triangles);
  EXPECT_TRUE(after.closed()) << "middles of edges are shared";
  EXPECT_NEAR(after.area, before.area, 1e-4 * before.area);
  EXPECT_NEAR(after.volume, before.volume, 1e-4 * before.volume);
  for (const Vec3 n : b.normals) EXPECT_NEAR(length(n), 1, 1e-5);
}

}  // namespace
}  // namespace aktina
