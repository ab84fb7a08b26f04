// Large scenes are drawn in passes: the picture is that of all triangles at once.
#include "aktina/raster/passes.h"

#include <gtest/gtest.h>

#include "raster/scenes.h"

namespace aktina {
namespace {

using test::add_matt;
using test::add_mesh;
using test::bumpy_sphere;
using test::quad;

constexpr int kSize = 96;

/// Three spheres, 180,000 triangles: a matt one, a shiny one before it and one that shines behind both.
Scene spheres() {
  Scene scene;
  const Mesh sphere = bumpy_sphere(300, 100);
  const auto add = [&](Point3 centre, int material) {
    Mat4 place(1);
    place[3] = Vec4(centre, 1);
    add_mesh(scene, sphere, material, place);
  };
  add({0.4f, 0, 0}, add_matt(scene, {0.2f, 0.4f, 0.8f}));
  add({0, 0.3f, 0.8f}, test::add_material(scene, {.kd = {0.6f, 0.5f, 0.1f}, .ks = Rgb(0.4f), .exponent = 30}));
  add({-0.8f, 0, -0.5f}, add_matt(scene, Rgb(0.5f)));
  scene.materials.back().emission = Radiance(Rgb(0.3f));
  scene.lights.push_back({"lamp", PointLight{{2, 3, 4}, Intensity(Rgb(40)), {}}, -1});
  scene.cameras.push_back(look_at({0.5f, 1, 6}, {0, 0, 0}, {0, 1, 0}, 0.7f));
  return scene;
}

/// A blended surface behind the camera: nothing of it is seen, but all triangles are wanted at once.
Scene at_once(Scene scene) {
  const int glass = add_matt(scene, Rgb(0.5f));
  scene.materials[size_t(glass)].alpha_mode = AlphaMode::blend;
  add_mesh(scene, quad({-1, -1, 9}, {1, -1, 9}, {1, 1, 9}, {-1, 1, 9}), glass);
  return scene;
}

void expect_equal(const RasterOptions& options) {
  const Scene scene = spheres(), whole = at_once(scene);
  const LayeredImage a = rasterize(scene, scene.cameras[0], kSize, kSize, options);
  const LayeredImage b = rasterize(whole, whole.cameras[0], kSize, kSize, options);
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (size_t i = 0; i < a.layers.size(); ++i)
    EXPECT_EQ(a.layers[i].image.pixels, b.layers[i].image.pixels) << options.shading << " " << a.layers[i].name;
}

TEST(Passes, PicturesAreThoseOfAllTrianglesAtOnce) {
  for (const char* shading : {"flat", "gouraud", "quadratic", "phong"}) expect_equal({.shading = shading});
}

TEST(Passes, LayersAndSamplesAreThoseOfAllTrianglesAtOnce) {
  expect_equal({.albedo = true, .normal = true, .position = true, .depth = true});
  expect_equal({.shading = "gouraud", .samples = 4});
}

TEST(Passes, OnlyWhereTheySaveMemory) {
  const Scene scene = spheres(), blended = at_once(scene);
  const auto per_pass = [](const Scene& s, const char* shading, int size) {
    PipelineSettings settings;
    settings.method = make_method(shading_methods(), "shading", shading);
    settings.unlit = settings.method;
    settings.model = make_method(illumination_models(), "illumination", "phong");
    settings.lights = scene_lights(s);
    const DrawList list(s);
    const View view(s.cameras[0], size, size);
    return chunks_per_pass(1000, Pipelines(settings, list, view.viewer()), view);
  };
  EXPECT_LT(per_pass(scene, "phong", 512), 100U);
  EXPECT_EQ(per_pass(scene, "phong", 8192), 1000U) << "bands of the whole picture would take more";
  EXPECT_EQ(per_pass(blended, "phong", 512), 1000U) << "blended triangles are sorted";
  EXPECT_EQ(per_pass(scene, "fast_phong", 512), 1000U) << "spans end where other triangles hide them";
}

}  // namespace
}  // namespace aktina
