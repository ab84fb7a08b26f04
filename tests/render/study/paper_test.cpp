#include "aktina/render/study/paper.h"

#include <gtest/gtest.h>

#include "aktina/scene/mesh_check.h"

namespace aktina {
namespace {

TEST(Teapot, HasItsMeasures) {
  const Mesh mesh = teapot(8);
  const Bounds box = bounds(mesh);
  const float scale = 2 / 6.525f;
  EXPECT_NEAR(box.size().y, 3.15f * scale, 1e-4) << "from the bottom to the knob";
  EXPECT_NEAR(box.low.z, -2 * scale, 1e-3) << "the body's greatest radius";
  EXPECT_NEAR(box.high.z, 2 * scale, 1e-3);
  EXPECT_GT(box.high.x, 3.2f * scale) << "the spout";
  EXPECT_LT(box.low.x, -2.9f * scale) << "the handle";
}

TEST(Teapot, FrontsFaceOutAndNormalsGoWithThem) {
  const Mesh mesh = teapot(6);
  EXPECT_GT(mesh.triangles.size(), 28u * 2 * 36);
  double volume = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 across = triangle_cross(mesh, t);
    EXPECT_GT(dot(across, mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]]), 0);
    volume += double(dot(mesh.positions[t[0]], across)) / 6;
  }
  EXPECT_GT(volume, 0.4) << "of a pot of 1.2 m across; inside out it would be negative";
}

TEST(Teapot, IsItsOwnMirrorImage) {
  const Mesh mesh = teapot(4);
  Vec3d mean(0);
  for (const Point3 p : mesh.positions) mean += Vec3d(p);
  EXPECT_NEAR(mean.z / double(mesh.positions.size()), 0, 1e-5);
}

TEST(PaperScenes, GrowFinerAndAreSeenWhole) {
  for (const PaperScene& scene : paper_scenes()) {
    ASSERT_GE(scene.levels.size(), 3u) << scene.name;
    for (size_t i = 1; i < scene.levels.size(); ++i)
      EXPECT_GT(triangle_count(scene.levels[i]), 2 * triangle_count(scene.levels[i - 1])) << scene.name;
    const Mat4 clip = clip_from_world(scene.levels[0].cameras[0], 400, 300);
    for (const Point3 p : scene.levels.back().meshes[0].positions) {
      const Vec4 q = clip * Vec4(p, 1);
      EXPECT_LT(std::abs(q.x), q.w) << scene.name;
      EXPECT_LT(std::abs(q.y), q.w) << scene.name;
    }
  }
}

TEST(PaperScenes, TheSphereIsClosed) {
  const PaperScene sphere = paper_scenes()[0];
  const Mesh& mesh = sphere.levels[1].meshes[0];
  const MeshCheck check = check_mesh(mesh.positions, mesh.triangles);
  EXPECT_TRUE(check.closed());
  EXPECT_EQ(check.inconsistent_edges, 0u);
  EXPECT_NEAR(check.volume, 4 * kPi / 3, 0.1);
}

}  // namespace
}  // namespace aktina
