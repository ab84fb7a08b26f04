#include "aktina/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aktina {
namespace {

Scene one_triangle() {
  Scene scene;
  Mesh& mesh = scene.meshes.emplace_back();
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  mesh.triangles = {{0, 1, 2}};
  scene.instances.push_back({.mesh = 0});
  return scene;
}

TEST(Scene, BoundsFollowInstances) {
  Scene scene = one_triangle();
  Mat4 moved(1);
  moved[3] = Vec4(10, 0, 0, 1);
  moved[1] = Vec4(0, -3, 0, 0);
  scene.instances.push_back({.mesh = 0, .to_world = moved});
  scene.primitives.push_back(Sphere{0.5f});
  scene.instances.push_back({.primitive = 0});
  EXPECT_EQ(bounds(scene).low, Point3(-0.5f, -6, -0.5f));
  EXPECT_EQ(bounds(scene).high, Point3(11, 2, 0.5f));
  EXPECT_EQ(triangle_count(scene), 2U);
}

TEST(Scene, DefaultCameraSeesEverything) {
  Scene scene = one_triangle();
  add_default_camera(scene);
  ASSERT_EQ(scene.cameras.size(), 1U);
  EXPECT_EQ(scene.warnings.items().size(), 1U);
  const Mat4 clip = clip_from_world(scene.cameras[0], 100, 100);
  for (const Point3 p : scene.meshes[0].positions) {
    const Vec4 c = clip * Vec4(p, 1);
    EXPECT_TRUE(std::abs(c.x) < c.w && std::abs(c.y) < c.w && std::abs(c.z) < c.w);
  }
  add_default_camera(scene);
  EXPECT_EQ(scene.cameras.size(), 1U);
}

TEST(Scene, DefaultLightOnlyWhereNothingShines) {
  Scene dark = one_triangle();
  EXPECT_FALSE(has_light(dark));
  add_default_light(dark);
  EXPECT_TRUE(has_light(dark));
  EXPECT_EQ(dark.lights.size(), 1U);
  EXPECT_EQ(dark.warnings.items().size(), 1U);

  Scene lamp = one_triangle();
  lamp.materials.emplace_back().emission = Radiance(Rgb(1));
  EXPECT_FALSE(has_light(lamp)) << "a material that nothing uses does not shine";
  lamp.instances[0].material = 0;
  EXPECT_TRUE(has_light(lamp));
}

TEST(Scene, HashSeesWhatAPictureSees) {
  const uint64_t original = hash(one_triangle()).value();
  EXPECT_EQ(hash(one_triangle()).value(), original);
  Scene scene = one_triangle();
  scene.meshes[0].name = "renamed";
  scene.source = "elsewhere.glb";
  EXPECT_EQ(hash(scene).value(), original) << "names do not matter";
  scene.meshes[0].positions[2].z = 1e-6f;
  EXPECT_NE(hash(scene).value(), original);
  scene = one_triangle();
  scene.lights.push_back({"", PointLight{}, -1});
  const uint64_t lit = hash(scene).value();
  EXPECT_NE(lit, original);
  std::get<PointLight>(scene.lights[0].light).intensity = Intensity(Rgb(2));
  EXPECT_NE(hash(scene).value(), lit);
}

TEST(Scene, MaterialOfAnInstance) {
  Scene scene = one_triangle();
  EXPECT_EQ(matt_reflectance(scene.material_of(scene.instances[0])), Rgb(0.8f));
  scene.materials.resize(2);
  scene.materials[0].name = "mesh", scene.materials[1].name = "instance";
  scene.meshes[0].material = 0;
  EXPECT_EQ(scene.material_of(scene.instances[0]).name, "mesh");
  scene.instances[0].material = 1;
  EXPECT_EQ(scene.material_of(scene.instances[0]).name, "instance");
}

TEST(Environment, LooksUpTheStatedDirections) {
  EnvironmentLight sky;
  sky.colour = Radiance(Rgb(2));
  EXPECT_EQ(radiance(sky, {0, 1, 0}).v, Rgb(2)) << "no image: the colour everywhere";
  sky.radiance = Image(4, 2, 3);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x) sky.radiance.set_rgb(x, y, Rgb(float(10 * y + x)));
  // u = atan2(x, -z) / 2 pi + 1/2: texel centres are at 1/8, 3/8, 5/8, 7/8
  const float height = std::tan(float(kPi / 4)) * std::sqrt(2.0f);  // v = 1/4: row 0
  EXPECT_NEAR(radiance(sky, {1, height, -1}).v.r, 2 * 2, 1e-4) << "azimuth 1/8 turn: u = 5/8";
  EXPECT_NEAR(radiance(sky, {-1, height, -1}).v.r, 2 * 1, 1e-4);
  EXPECT_NEAR(radiance(sky, {1, -height, 1}).v.r, 2 * 13, 1e-4);
  sky.rotation = float(kPi / 2);  // what stood at -z stands at -x now
  EXPECT_NEAR(radiance(sky, {-1, height, -1}).v.r, 2 * 2, 1e-4);
}

TEST(Scene, HashSeesWhatALuminaireMeasured) {
  const auto table = [](float candela) {
    return std::make_shared<const PhotometricTable>(PhotometricTable{{0}, {0, 90}, {candela, 0}});
  };
  Scene a, b;
  a.lights.push_back({"lamp", LuminaireLight{.table = table(1)}, -1});
  b.lights.push_back({"lamp", LuminaireLight{.table = table(1)}, -1});
  EXPECT_EQ(hash(a).value(), hash(b).value()) << "by value, not by address";
  b.lights.front().light = LuminaireLight{.table = table(2)};
  EXPECT_NE(hash(a).value(), hash(b).value());
}

}  // namespace
}  // namespace aktina
