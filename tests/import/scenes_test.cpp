// Aktina's own scenes, through the file dispatch.
#include <gtest/gtest.h>

#include "aktina/import/import.h"
#include "test_files.h"

namespace aktina {
namespace {

TEST(OwnScenes, Cornell) {
  const Scene scene = load_scene(test::repository() / "scenes" / "cornell.glb");
  EXPECT_EQ(scene.meshes.size(), 8u);
  EXPECT_EQ(triangle_count(scene), 36u) << "six quads and two boxes of six";
  const Bounds b = bounds(scene);
  EXPECT_NEAR(b.size().x, 0.556, 1e-6);
  EXPECT_NEAR(b.size().y, 0.5488, 1e-6);
  EXPECT_NEAR(b.size().z, 0.5592, 1e-6);
  const Material& light = scene.material_of(scene.instances.back());
  EXPECT_EQ(light.emission.v, Rgb(3000)) << "emissive strength, cd/m^2";
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_NEAR(scene.cameras[0].vertical_fov, 0.686, 1e-6);
  EXPECT_NEAR(scene.cameras[0].position().z, 0.8, 1e-6);
  EXPECT_NEAR(scene.cameras[0].forward().z, -1, 1e-6);
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(scene.generator, "Aktina scenes/generate.py");
}

TEST(OwnScenes, Room) {
  const Scene scene = load_scene(test::repository() / "scenes" / "room.glb");
  EXPECT_GT(triangle_count(scene), 10000u);
  for (const Mesh& mesh : scene.meshes) {
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size()) << mesh.name;
    EXPECT_EQ(mesh.uv[0].size(), mesh.positions.size()) << mesh.name;
  }
  ASSERT_EQ(scene.lights.size(), 1u);
  const auto& spot = std::get<SpotLight>(scene.lights[0].light);
  EXPECT_NEAR(spot.intensity.v.r, 220, 1e-4);
  EXPECT_NEAR(spot.inner_angle, 0.3, 1e-6);
  EXPECT_LT(spot.direction.y, -0.99f) << "shines down";
  ASSERT_EQ(scene.images.size(), 2u);
  const auto named = [&](const char* name) {
    for (const Material& m : scene.materials)
      if (m.name == name) return m;
    return Material{};
  };
  EXPECT_EQ(named("glass").transmission, 1);
  EXPECT_EQ(named("glass").metallic, 0);
  EXPECT_TRUE(named("lamp shade").double_sided);
  EXPECT_TRUE(bool(named("oak floor").base_texture));
  EXPECT_NE(named("oak").original.find("\"name\":\"oak\""), std::string::npos);
}

}  // namespace
}  // namespace aktina
