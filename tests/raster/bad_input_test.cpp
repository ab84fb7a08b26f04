// Every shading method gives finite colours that are not negative, whatever the scene holds.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "aktina/base/random.h"
#include "aktina/raster/rasterize.h"
#include "aktina/raster/shading/shading_method.h"
#include "raster/scenes.h"

namespace aktina {
namespace {

float one_of(Pcg32& random, std::initializer_list<float> values) {
  return values.begin()[random.next() % uint32_t(values.size())];
}
Vec3 any_vector(Pcg32& random, float size) {
  return size * Vec3(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
}

/// Some triangles around the origin: slivers, points and backs among them; normals of zero, opposite, or not facing.
Mesh wild_mesh(Pcg32& random) {
  Mesh mesh;
  for (uint32_t t = 0; t < 8; ++t) {
    const Point3 a = any_vector(random, 1), b = any_vector(random, 1);
    const float kind = one_of(random, {0, 1, 2, 3});
    mesh.positions.insert(mesh.positions.end(),
                          {a, kind == 1 ? a : b, kind == 2 ? 0.5f * (a + b) : any_vector(random, 1)});
    for (int v = 0; v < 3; ++v) {
      const Vec3 n = normalize_or(any_vector(random, 1), {0, 0, 1});
      mesh.normals.push_back(v > 0 && kind == 3 ? -mesh.normals.back() : one_of(random, {0, 1, 1, 1}) * n);
    }
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

Scene wild_scene(Pcg32& random) {
  Scene scene;
  ClassicMaterial m{.ka = Rgb(0.1f), .kd = Rgb(0.6f), .ks = Rgb(0.5f)};
  m.exponent = one_of(random, {0, 0.5f, 1, 20, 300, 1e6f, -3});
  const Mesh mesh = wild_mesh(random);
  test::add_mesh(scene, mesh, test::add_material(scene, m));
  scene.lights.push_back({"on the surface", PointLight{mesh.positions[0], Intensity(Rgb(3)), {}}, -1});
  scene.lights.push_back(
      {"sun", DirectionalLight{normalize_or(any_vector(random, 1), {0, 0, 1}), Irradiance(Rgb(2))}, -1});
  SpotLight spot{any_vector(random, 2), {0, 0, -1}, Intensity(Rgb(9))};
  spot.inner_angle = 0, spot.outer_angle = one_of(random, {0, 0.5f, float(kPi)});
  spot.exponent = one_of(random, {0, 40});
  scene.lights.push_back({"spot", spot, -1});
  scene.cameras.push_back(look_at(one_of(random, {0.3f, 2, 5}) * Vec3(0.3f, 0.2f, 1), {0, 0, 0}, {0, 1, 0}, 1));
  scene.cameras[0].near = 0.05f;
  return scene;
}

/// The lamp on the surface has no bound; all others give less than this.
constexpr float kMost = 1e35f;

RC_GTEST_PROP(BadInput, EveryShadingMethodGivesFiniteColours, ()) {
  Pcg32 random(*rc::gen::arbitrary<uint32_t>());
  const Scene scene = wild_scene(random);
  const int size = int(one_of(random, {1, 2, 40}));
  const char* models[] = {"lambert", "phong", "blinn_phong"};
  for (const ShadingRow* row : shading_methods()) {
    const std::string name(row->info.id);
    const RasterOptions options{.shading = name, .illumination = models[random.next() % 3], .normal = size == 2};
    const Image p = rasterize(scene, scene.cameras[0], size, size, options).layers[0].image;
    for (const float c : p.pixels)
      if (!(c >= 0 && c < kMost)) RC_FAIL(name + " gives " + std::to_string(c));
  }
}

}  // namespace
}  // namespace aktina
