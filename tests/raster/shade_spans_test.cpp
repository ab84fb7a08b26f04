// Pictures by methods on spans: pixel by pixel what the readable form says, also of cut, textured, masked and blended
// surfaces.
#include <gtest/gtest.h>

#include "aktina/base/parallel.h"
#include "aktina/raster/rasterize.h"
#include "aktina/raster/shading/shade_triangle.h"
#include "aktina/raster/view.h"
#include "aktina/scene/scene_lights.h"
#include "raster/scenes.h"

namespace aktina {
namespace {

const ClassicMaterial kPlastic{.ka = Rgb(0.2f), .kd = {0.6f, 0.45f, 0.3f}, .ks = Rgb(0.4f), .exponent = 20};

Scene bumpy_scene() {
  Scene scene;
  test::add_mesh(scene, test::bumpy_sphere(36, 20), test::add_material(scene, kPlastic));
  scene.lights.push_back({"lamp", PointLight{{3, 2, 4}, Intensity({20, 30, 25}), {}}, -1});
  scene.lights.push_back({"sun", DirectionalLight{normalize(Vec3(1, -1, -1)), Irradiance({2, 1, 1})}, -1});
  scene.ambient = Rgb(0.3f);
  scene.cameras.push_back(look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 0.8f));
  return scene;
}

Image picture(const Scene& scene, int width, int height, const RasterOptions& options) {
  return rasterize(scene, scene.cameras[0], width, height, options).layers[0].image;
}

std::vector<std::string> methods_on_spans() {
  const Illuminator any(Phong{}, Surface(), {}, Rgb(), Viewer());
  std::vector<std::string> out;
  for (const ShadingRow* row : shading_methods())
    if (row->make(ParamSet(row->info))->plan(any).kind == ShadingPlan::Kind::spans) out.emplace_back(row->info.id);
  return out;
}

/// Triangle `item` of the first mesh, as a view sees it, its normals turned to the viewer.
ShadedTriangle seen_triangle(const Scene& scene, const View& view, uint32_t item) {
  ShadedTriangle t;
  const Mesh& mesh = scene.meshes[0];
  for (size_t v = 0; v < 3; ++v) {
    const uint32_t at = mesh.triangles[item][v];
    const ScreenVertex s = view.project(view.clip_from_world() * Vec4(mesh.positions[at], 1));
    t.position[v] = mesh.positions[at], t.normal[v] = mesh.normals[at];
    t.screen[v] = {float(s.x) / kSubpixels, float(s.y) / kSubpixels};
    t.weight[v] = s.weight;
  }
  const Vec3 face = cross(t.position[1] - t.position[0], t.position[2] - t.position[0]);
  if (dot(face, view.viewer().towards(t.position[0])) < 0)
    for (Vec3& n : t.normal) n = -n;
  return t;
}

Vec3 barycentric(const ShadedTriangle& t, Vec2 p) {
  const auto area = [](Vec2 a, Vec2 b, Vec2 c) {
    return (double(b.x) - a.x) * (double(c.y) - a.y) - (double(c.x) - a.x) * (double(b.y) - a.y);
  };
  const double whole = area(t.screen[0], t.screen[1], t.screen[2]);
  return Vec3(float(area(p, t.screen[1], t.screen[2]) / whole), float(area(t.screen[0], p, t.screen[2]) / whole),
              float(area(t.screen[0], t.screen[1], p) / whole));
}

TEST(ShadeSpans, PicturesAreWhatTheReadableFormSays) {
  const Scene scene = bumpy_scene();
  constexpr int kWidth = 70, kHeight = 50;
  const View view(scene.cameras[0], kWidth, kHeight);
  const ItemBuffer items = rasterize_items(scene, scene.cameras[0], kWidth, kHeight);
  const SceneLights lights = scene_lights(scene);
  const Illuminator light(Phong{}, surface_of(scene.materials[0]), lights.lights, lights.ambient, view.viewer());
  for (const std::string& name : methods_on_spans()) {
    const auto method = make_method(shading_methods(), "shading", name);
    const Image p = picture(scene, kWidth, kHeight, {.shading = name});
    int seen = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const uint32_t item = items.item[size_t(y * kWidth + x)];
        if (item == ItemBuffer::kNothing) continue;
        ++seen;
        const ShadedTriangle t = seen_triangle(scene, view, item);
        const Vec3 b = barycentric(t, {float(x) + 0.5f, float(y) + 0.5f});
        const Rgb expected = shade(*method, light, t, std::span(&b, 1))[0].total();
        for (int k = 0; k < 3; ++k)
          ASSERT_NEAR(p.rgb(x, y)[k], expected[k], 2e-3 * (1 + expected[k])) << name << ' ' << x << ' ' << y;
      }
    EXPECT_GT(seen, 700);
  }
}

TEST(ShadeSpans, TheSameBytesForAnyNumberOfThreadsAndLayers) {
  const Scene scene = bumpy_scene();
  for (const std::string& name : methods_on_spans()) {
    const auto draw = [&](int threads) {
      set_thread_count(threads);
      return picture(scene, 150, 140, {.shading = name, .samples = 4});
    };
    const Image one = draw(1), three = draw(3);
    set_thread_count(0);
    EXPECT_EQ(one.pixels, three.pixels) << name;
    const Image plain = picture(scene, 90, 90, {.shading = name});
    const LayeredImage layered =
        rasterize(scene, scene.cameras[0], 90, 90, {.shading = name, .albedo = true, .normal = true, .depth = true});
    for (size_t i = 0; i < plain.pixels.size(); ++i)
      ASSERT_NEAR(layered.layers[0].image.pixels[i], plain.pixels[i], 1e-4) << name;
    const float* n = layered.find("N")->at(45, 45);
    EXPECT_NEAR(length(Vec3(n[0], n[1], n[2])), 1, 1e-3);
  }
}

TEST(ShadeSpans, BlendedSurfacesLieOverWhatIsBehind) {
  Scene scene = bumpy_scene();
  scene.background = Radiance(Rgb(3));
  const LayeredImage opaque =
      rasterize(scene, scene.cameras[0], 60, 60, {.shading = "fence", .cull_back_faces = true, .depth = true});
  scene.materials[0].alpha = 0.25f, scene.materials[0].alpha_mode = AlphaMode::blend;
  scene.materials[0].double_sided = false;
  const Image veil = picture(scene, 60, 60, {.shading = "fence", .cull_back_faces = true});
  int seen = 0;
  for (int y = 20; y < 40; ++y)
    for (int x = 20; x < 40; ++x) {
      if (!std::isfinite(*opaque.find("Z")->at(x, y))) continue;
      const float front = opaque.layers[0].image.rgb(x, y).g, one = 3 + 0.25f * (front - 3);
      if (std::abs(veil.rgb(x, y).g - one) < 1e-4f) ++seen;  // the others look through two bumps
    }
  EXPECT_GT(seen, 200);
}

/// Two unlike halves of a square that passes under the eye: the near plane cuts it.
TEST(ShadeSpans, CutTrianglesHaveTheirLight) {
  Scene scene;
  test::add_mesh(scene, test::quad({-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}),
                 test::add_material(scene, {.ka = Rgb(0.2f), .kd = Rgb(0.7f)}));
  scene.lights.push_back({"sun", DirectionalLight{normalize(Vec3(0.3f, 0.2f, -1)), Irradiance(Rgb(3))}, -1});
  scene.cameras.push_back(look_at({0, -0.5f, 0.3f}, {0.2f, 0.5f, 0}, {0, 0, 1}, 1.2f));
  scene.cameras[0].near = 0.2f;
  const Image flat = picture(scene, 80, 80, {.shading = "flat"});
  for (const std::string& name : methods_on_spans()) {
    const Image p = picture(scene, 80, 80, {.shading = name});
    for (size_t i = 0; i < p.pixels.size(); ++i) ASSERT_NEAR(p.pixels[i], flat.pixels[i], 1e-4) << name;
  }
}

TEST(ShadeSpans, TexturesMultiplyDiffuseLight) {
  Scene scene = bumpy_scene();
  scene.materials[0].classic->ks = Rgb(0), scene.materials[0].classic->ka = Rgb(0);
  TextureImage image;
  image.pixels = Bitmap{1, 1, 3, true, {188, 188, 188}};
  scene.images.push_back(image);
  for (const Point3 p : scene.meshes[0].positions) scene.meshes[0].uv[0].push_back({p.x, p.y});
  for (const std::string& name : methods_on_spans()) {
    scene.materials[0].base_texture = {};
    const Image plain = picture(scene, 50, 50, {.shading = name});
    scene.materials[0].base_texture.image = 0;
    const Image textured = picture(scene, 50, 50, {.shading = name});
    const float texel = look_up(scene.images[0], scene.materials[0].base_texture, {0.5f, 0.5f}, true).x;
    for (size_t i = 0; i < plain.pixels.size(); ++i)
      ASSERT_NEAR(textured.pixels[i], texel * plain.pixels[i], 1e-4 + 1e-3 * plain.pixels[i]) << name;
  }
}

}  // namespace
}  // namespace aktina
