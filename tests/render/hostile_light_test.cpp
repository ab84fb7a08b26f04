// Lights and surfaces at the limits of what numbers hold: pictures stay finite.
#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/illumination/model.h"
#include "aktina/render/job.h"
#include "aktina/scene/scene_lights.h"

namespace aktina {
namespace {

/// A square with normals of no length on one side and turned inwards on the other, and a triangle without area.
Scene scene_with(float exponent, bool lit) {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.normals = {{0, 0, 0}, {0, 0, -1}, {0, 0, 1}, {0, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 2}, {1, 1, 2}};  // one of them inside out
  mesh.material = 0;
  scene.meshes.push_back(mesh);
  scene.materials.push_back(material_of(ClassicMaterial{.ks = Rgb(1), .exponent = 30}));
  scene.materials[0].classic->exponent = exponent;
  scene.instances.push_back({.mesh = 0});
  scene.cameras.push_back(look_at({0.3f, 0.2f, 2}, {0, 0, 0}, {0, 1, 0}, 0.9f));
  scene.cameras.push_back(look_at({3, 0, 0.001f}, {0, 0, 0}, {0, 0, 1}, 0.9f));  // grazing
  if (!lit) return scene;
  scene.lights.push_back({"on the surface", PointLight{}, -1});
  SpotLight closed{.position = {0, 0, 1}, .inner_angle = 0, .outer_angle = 0}, open = closed;
  open.inner_angle = open.outer_angle = float(kPi), open.exponent = 1e6f;
  scene.lights.push_back({"closed", closed, -1}), scene.lights.push_back({"open", open, -1});
  scene.lights.push_back({"warn", WarnLight{.position = {0, 0, 1}, .exponent = 1e6f, .cone_angle = 0}, -1});
  scene.lights.push_back({"along", DirectionalLight{{1, 0, 0}, Irradiance(Rgb(3))}, -1});
  scene.lights.push_back({"empty", LuminaireLight{}, -1});
  place_light(scene, {"in the plane", RectangleLight{.corner = {0, 0, 0}}, -1});
  place_light(scene, {"beside", DiscLight{.position = {1, 0, 0}, .direction = {-1, 0, 0}}, -1});
  return scene;
}

TEST(HostileLight, NoPictureHoldsNaN) {
  for (const float exponent : {0.0f, -5.0f, 1e6f})
    for (const bool lit : {true, false}) {
      const Scene scene = scene_with(exponent, lit);
      for (const int camera : {0, 1})
        for (const auto& [method, size] : {std::pair("raster", 1), std::pair("raster", 9), std::pair("whitted", 5)})
          for (const auto* row : illumination_models()) {
            if (std::string_view(method) != "raster" && row != illumination_models()[0]) continue;
            RenderOptions options;
            options.method = method, options.width = options.height = size, options.samples = 1;
            options.camera = camera, options.illumination = row->info.id;
            Progress progress;
            const Rendering rendering = render(scene, options, progress);
            for (const float value : rendering.picture.layers[0].image.pixels)
              ASSERT_TRUE(std::isfinite(value) && value >= 0) << method << " " << row->info.id << " " << exponent;
          }
    }
}

TEST(HostileLight, DepthCueingIsOfRasterAndWhittedAndChecked) {
  const Scene scene = scene_with(1, true);
  Progress progress;
  const auto fault = [&](const char* method, DepthCue cue) -> std::string {
    RenderOptions options;
    options.method = method, options.width = options.height = 2, options.samples = 1, options.depth_cue = cue;
    try {
      render(scene, options, progress);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  for (const char* method : {"raster", "whitted"}) {
    EXPECT_EQ(fault(method, {0.5f, 0.1f}), "");
    EXPECT_EQ(fault(method, {0, 1}), "");
    for (const DepthCue wrong : {DepthCue{0, 0}, DepthCue{-1, 1}, DepthCue{1, kInfinity}, DepthCue{NAN, 1}})
      EXPECT_NE(fault(method, wrong).find("depth_cue"), std::string::npos) << method;
  }
  for (const char* method : {"path", "direct", "radiosity", "two_pass"})
    EXPECT_NE(fault(method, {1, 0.1f}).find("raster and whitted"), std::string::npos) << method;
}

}  // namespace
}  // namespace aktina
