// What FBX, COLLADA and 3DS say arrives: places, units, axes, materials, lights, cameras.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "aktina/base/error.h"
#include "aktina/image/file_format.h"
#include "aktina/import/import.h"
#include "import/assimp/binary_fbx.h"
#include "import/assimp/sample_files.h"
#include "import/reading.h"
#include "test_files.h"

namespace aktina {
namespace {

constexpr float kInch = 0.0254f;  // m

using test::bare;
using test::bytes_of;
using test::warned;

Scene fbx(const Path& folder = "/nowhere", const ImportOptions& options = bare()) {
  return read_fbx(bytes_of(test::kFbx), folder, "a.fbx", options);
}
Scene collada(const Path& folder = "/nowhere", const ImportOptions& options = bare()) {
  return read_collada(bytes_of(test::kCollada), folder, "a.dae", options);
}
Scene max3ds(const ImportOptions& options = bare()) {
  return read_3ds(bytes_of(test::max3ds_file()), "/nowhere", "a.3ds", options);
}

void expect_near(Vec3 a, Vec3 b, float tolerance = 1e-4f) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}
const Instance& instance_at(const Scene& scene, std::string_view node) {
  for (const Instance& instance : scene.instances)
    if (instance.node >= 0 && scene.nodes[size_t(instance.node)].name == node) return instance;
  ADD_FAILURE() << "no instance at " << node;
  return scene.instances.at(0);
}
const PlacedLight& light_named(const Scene& scene, std::string_view name) {
  for (const PlacedLight& light : scene.lights)
    if (light.name == name) return light;
  ADD_FAILURE() << "no light " << name;
  return scene.lights.at(0);
}
void save_picture(const Path& path) { write_image(path, Image(2, 2, 3)); }

// The parent turns x to y and y to -x, lifts by 100; then z is up: (x, y, z) -> (x, z, -y), in inches.
TEST(Fbx, PlacesInMetresWithYUp) {
  const Scene scene = fbx();
  const Mat4 a = instance_at(scene, "A").to_world, b = instance_at(scene, "B").to_world;
  expect_near(transform_point(a, {100, 50, 0}), Vec3(-50, 100, -110) * kInch);
  expect_near(transform_point(b, {100, 50, 0}), Vec3(-100, 114, -220) * kInch);  // twice as large, 2 x 7 above
  EXPECT_DOUBLE_EQ(scene.metres_per_unit, 0.0254);
  EXPECT_EQ(instance_at(scene, "A").mesh, instance_at(scene, "B").mesh) << "one mesh, two places";
  EXPECT_EQ(scene.meshes[0].positions.size(), 4u);
  EXPECT_EQ(scene.meshes[0].faces(), 1u) << "the polygon is remembered";
  EXPECT_EQ(scene.generator, "written by hand");
  expect_near(triangle_cross(scene.meshes[0], scene.meshes[0].triangles[0]), {0, 0, 5000}, 1e-2f);
}

TEST(Fbx, UnitsCanBeSaidOtherwise) {
  ImportOptions options = bare();
  options.metres_per_unit = 1;
  const Scene scene = fbx("/nowhere", options);
  expect_near(transform_point(instance_at(scene, "A").to_world, {100, 50, 0}), {-50, 100, -110}, 1e-2f);
  expect_near(scene.cameras.at(0).position(), {0, 0, 300}, 1e-2f);
}

TEST(Fbx, MaterialsAreClassic) {
  const Material m = fbx().materials.at(0);
  ASSERT_TRUE(m.classic);
  EXPECT_EQ(m.name, "Red");
  EXPECT_NEAR(m.classic->kd.r, 0.8f * 0.5f, 1e-6) << "colour times factor";
  EXPECT_NEAR(m.classic->ks.r, 0.4f * 0.5f, 1e-6);
  EXPECT_FLOAT_EQ(m.classic->exponent, 25);
  EXPECT_NEAR(m.emission.v.b, 0.6f, 1e-6);
  EXPECT_NEAR(m.alpha, 0.75f, 1e-6);
  EXPECT_EQ(m.alpha_mode, AlphaMode::blend);
}

// White paper facing a lamp of colour c at distance d has c / d^2 of brightness: pi c / d^2 lx, d in the file's units.
TEST(Fbx, LampsAreAsBrightAsTheClassicModelHasThem) {
  const PlacedLight placed = light_named(fbx(), "Lamp");
  const auto& spot = std::get<SpotLight>(placed.light);
  expect_near(spot.position, Vec3(0, 200, 0) * kInch);
  EXPECT_NEAR(spot.inner_angle, 10 * kPi / 180, 1e-5) << "half of the whole angle";
  EXPECT_NEAR(spot.outer_angle, 30 * kPi / 180, 1e-5);
  // Lights shine along -y of their node, which is +z here, since z is up.
  expect_near(spot.direction, {0, 0, 1});
  const LightSample at = sample(spot, spot.position + spot.direction * (10 * kInch));
  EXPECT_NEAR(at.e_perp.v.r, kPi * 4 / 100, 1e-4) << "intensity 400 % at 10 units";
  EXPECT_NEAR(at.e_perp.v.g, kPi * 2 / 100, 1e-4);
}

TEST(Fbx, CamerasLookAlongX) {
  const Camera camera = fbx().cameras.at(0);
  expect_near(camera.position(), Vec3(0, 0, 300) * kInch);
  expect_near(camera.forward(), {0, 0, -1});  // x, turned to y, which is -z here
  EXPECT_NEAR(camera.aspect, 1.6f, 1e-5);
  EXPECT_NEAR(camera.vertical_fov, 2 * std::atan(std::tan(kPi / 6) / 1.6), 1e-4);
  EXPECT_NEAR(camera.near, kInch, 1e-6);
}

TEST(Fbx, PicturesTakeTheColoursPlaceWhereTheyAreThere) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(warned(fbx(folder.path()), "'wood.png' is missing"), 1u);
  save_picture(folder / "wood.png");
  const Scene scene = fbx(folder.path());
  const Material& m = scene.materials.at(0);
  ASSERT_TRUE(m.base_texture);
  EXPECT_FLOAT_EQ(m.classic->kd.r, 1);
  EXPECT_EQ(scene.images.at(0).uri, "wood.png");
  EXPECT_FLOAT_EQ(scene.meshes[0].uv[0].at(0).y, 1) << "v runs down here";
}

TEST(Fbx, OtherAxes) {
  std::string text = test::kFbx;
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("\"UpAxis\", \"int\", \"Integer\", \"\",2", "\"UpAxis\", \"int\", \"Integer\", \"\",1");
  replace("\"FrontAxis\", \"int\", \"Integer\", \"\",1", "\"FrontAxis\", \"int\", \"Integer\", \"\",2");
  replace("\"FrontAxisSign\", \"int\", \"Integer\", \"\",-1", "\"FrontAxisSign\", \"int\", \"Integer\", \"\",1");
  const Scene scene = read_fbx(bytes_of(text), "/nowhere", "y.fbx", bare());
  expect_near(transform_point(instance_at(scene, "A").to_world, {100, 50, 0}), Vec3(-50, 110, 100) * kInch);
  replace("\"CoordAxisSign\", \"int\", \"Integer\", \"\",1", "\"CoordAxisSign\", \"int\", \"Integer\", \"\",-1");
  EXPECT_EQ(warned(read_fbx(bytes_of(text), "/nowhere", "m.fbx", bare()), "axes that do not fit"), 1u);
}

TEST(Fbx, Binary) {
  const Scene scene = read_fbx(bytes_of(test::binary_fbx_file()), "/nowhere", "b.fbx", bare());
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].triangles.size(), 1u);
  expect_near(bounds(scene).high, {0.5f, 1, 0});
}

TEST(Collada, PlacesInMetresWithYUp) {
  const Scene scene = collada();
  expect_near(transform_point(instance_at(scene, "A").to_world, {100, 50, 0}), Vec3(-50, 100, -110) * kInch);
  expect_near(transform_point(instance_at(scene, "B").to_world, {100, 50, 0}), Vec3(-100, 100, -200) * kInch);
  EXPECT_DOUBLE_EQ(scene.metres_per_unit, 0.0254);
  EXPECT_EQ(scene.nodes[0].parent, -1);
  ImportOptions options = bare();
  options.metres_per_unit = 0.5;
  expect_near(transform_point(instance_at(collada("/nowhere", options), "A").to_world, {100, 50, 0}),
              Vec3(-50, 100, -110) * 0.5f, 1e-3f);
}

TEST(Collada, MaterialsAreClassic) {
  const Material m = collada().materials.at(0);
  ASSERT_TRUE(m.classic);
  EXPECT_NEAR(m.classic->ka.g, 0.02f, 1e-6);
  EXPECT_NEAR(m.classic->ks.r, 0.4f, 1e-6);
  EXPECT_NEAR(m.classic->kr.r, 0.3f, 1e-6);
  EXPECT_FLOAT_EQ(m.classic->exponent, 25);
  EXPECT_NEAR(m.classic->index, 1.4f, 1e-6);
  EXPECT_NEAR(m.alpha, 0.75f, 1e-6);
  EXPECT_NEAR(m.emission.v.g, 0.2f, 1e-6);
}

TEST(Collada, LightsOfEveryKind) {
  const Scene scene = collada();
  const auto& bulb = std::get<PointLight>(light_named(scene, "Bulb").light);
  expect_near(bulb.position, Vec3(0, 20, 0) * kInch);
  EXPECT_NEAR(sample(bulb, bulb.position + Vec3(10 * kInch, 0, 0)).e_perp.v.r, kPi, 1e-3) << "100 / 10^2";
  const auto& plain = std::get<PointLight>(light_named(scene, "Plain").light);
  EXPECT_NEAR(sample(plain, {5, 5, 5}).e_perp.v.r, kPi, 1e-4) << "the same at any distance";
  const auto& sun = std::get<DirectionalLight>(light_named(scene, "Sun").light);
  EXPECT_NEAR(sun.e_perp.v.r, 3 * kPi, 1e-4);
  expect_near(sun.direction, {0, -std::cos(float(kPi / 6)), -std::sin(float(kPi / 6))});
  const auto& spot = std::get<SpotLight>(light_named(scene, "Spot").light);
  EXPECT_NEAR(spot.outer_angle, kPi / 6, 1e-5) << "half of the whole angle";
  EXPECT_NEAR(spot.exponent, 4, 1e-3);
  EXPECT_NEAR(scene.ambient.b, 0.3f, 1e-6);
}

TEST(Collada, CamerasKeepTheirVerticalAngle) {
  const Camera camera = collada().cameras.at(0);
  expect_near(camera.position(), Vec3(0, 7, 0) * kInch);
  expect_near(camera.forward(), {0, -1, 0});
  EXPECT_NEAR(camera.vertical_fov, 40 * kPi / 180, 1e-3);
  EXPECT_EQ(warned(collada(), "orthographic"), 1u);
}

TEST(Max3ds, HasNoUnitAndZUp) {
  const Scene scene = max3ds();
  EXPECT_DOUBLE_EQ(scene.metres_per_unit, 1);
  const Bounds box = bounds(scene);
  expect_near(box.low, {0, 0, -50});
  expect_near(box.high, {100, 0, 0});
  ImportOptions options = bare();
  options.metres_per_unit = 0.01;
  expect_near(bounds(max3ds(options)).high, {1, 0, 0});
}

TEST(Max3ds, MaterialsLightsCameras) {
  const Scene scene = max3ds();
  const Material& m = scene.materials.at(0);
  EXPECT_EQ(m.name, "Red");
  EXPECT_NEAR(m.classic->kd.r, 0.8f, 1e-6);
  EXPECT_NEAR(m.classic->ks.r, 0.4f * 0.5f, 1e-6);
  EXPECT_NEAR(m.alpha, 0.75f, 1e-6);
  const auto& lamp = std::get<PointLight>(light_named(scene, "Lamp").light);
  expect_near(lamp.position, {0, 200, 0});
  EXPECT_NEAR(sample(lamp, {0, 0, 0}).e_perp.v.g, kPi / 2, 1e-4);
  const auto& spot = std::get<SpotLight>(light_named(scene, "Spot").light);
  expect_near(spot.direction, {0, -1, 0});
  EXPECT_NEAR(spot.inner_angle, 10 * kPi / 180, 1e-5);
  EXPECT_NEAR(spot.outer_angle, 30 * kPi / 180, 1e-5);
  const Camera& camera = scene.cameras.at(0);
  expect_near(camera.position(), {0, 0, 300});
  expect_near(camera.forward(), {0, 0, -1});
  expect_near(Vec3(camera.to_world[1]), {0, 1, 0});
  // A lens of 48 mm sees 2400 / 48 = 50 degrees from left to right.
  EXPECT_NEAR(std::tan(camera.vertical_fov / 2) * camera.aspect, std::tan(25 * kPi / 180), 1e-4);
}

TEST(AssimpFormats, AreKnownByContent) {
  const test::TemporaryFolder folder;
  const auto load = [&](std::string_view text) {
    std::ofstream(folder / "scene.xyz", std::ios::binary) << text;
    return load_scene(folder / "scene.xyz", bare());
  };
  EXPECT_EQ(load(test::kFbx).instances.size(), 2u);
  EXPECT_EQ(load(test::kCollada).instances.size(), 2u);
  EXPECT_EQ(load(test::max3ds_file()).instances.size(), 1u);
}

TEST(AssimpFormats, PicturesOutsideTheFolderAreNotReached) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "inner");
  save_picture(folder / "wood.png");
  std::string text = test::kCollada;
  text.replace(text.find("wood.png"), 8, "../wood.png");
  const Scene scene = read_collada(bytes_of(text), folder / "inner", "a.dae", bare());
  EXPECT_EQ(warned(scene, "'../wood.png' is missing"), 1u);
  EXPECT_TRUE(scene.images.empty());
}

}  // namespace
}  // namespace aktina
