// Scenes that rays are timed on.
#pragma once

#include <cmath>

#include "tests/raster/scenes.h"

namespace aktina::bench {

inline int add_lamp_material(Scene& scene, float radiance) {
  const int lamp = test::add_matt(scene, Rgb(0));
  scene.materials[size_t(lamp)].emission = Radiance(Rgb(radiance));
  return lamp;
}

/// The Cornell box as path tracers are compared on it: 36 triangles, a lamp in a unit box (z up) open to the camera.
inline Scene cornell_box_36() {
  Scene scene;
  const int white = test::add_matt(scene, Rgb(0.73f)), red = test::add_matt(scene, {0.65f, 0.05f, 0.05f}),
            green = test::add_matt(scene, {0.12f, 0.45f, 0.15f}), lamp = add_lamp_material(scene, 15);
  const auto add = [&](int material, Point3 a, Point3 b, Point3 c, Point3 d) {
    test::add_mesh(scene, test::quad(a, b, c, d), material);
    scene.meshes.back().normals.clear();
    scene.meshes.back().uv[0].clear();
  };
  add(white, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  add(white, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1});
  add(white, {0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1});
  add(red, {0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1});
  add(green, {1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0});
  add(lamp, {0.35f, 0.35f, 0.999f}, {0.35f, 0.65f, 0.999f}, {0.65f, 0.65f, 0.999f}, {0.65f, 0.35f, 0.999f});
  const auto box = [&](float height, float degrees, float x, float y) {
    const float c = std::cos(degrees * float(kPi / 180)), s = std::sin(degrees * float(kPi / 180));
    const auto corner = [&](int i) {
      const float px = i & 4 ? 0.3f : 0, py = i & 2 ? 0.3f : 0;
      return Point3(x + c * px - s * py, y + s * px + c * py, i & 1 ? height : 0);
    };
    for (const auto& f : {std::array{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}})
      add(white, corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3]));
  };
  box(0.6f, 17, 0.15f, 0.5f);
  box(0.3f, -18, 0.55f, 0.2f);
  scene.cameras.push_back(look_at({0.5f, -1.35f, 0.5f}, {0.5f, 0, 0.5f}, {0, 0, 1}, float(40 * kPi / 180)));
  return scene;
}

/// A bumpy sphere of 281,248 triangles in a box with a lamp.
inline Scene bumpy_sphere_in_a_box() {
  Scene scene;
  const int clay = test::add_matt(scene, {0.7f, 0.6f, 0.4f}), white = test::add_matt(scene, Rgb(0.73f)),
            lamp = add_lamp_material(scene, 15);
  test::add_mesh(scene, test::bumpy_sphere(376, 374), clay);
  scene.meshes.back().normals.clear();
  const float h = 3;
  const auto corner = [&](int i) { return Point3(i & 4 ? h : -h, i & 2 ? h : -h, i & 1 ? h : -h); };
  for (const auto& f : {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    test::add_mesh(scene, test::quad(corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3])), white);
  test::add_mesh(scene, test::quad({-1, 2.99f, -1}, {1, 2.99f, -1}, {1, 2.99f, 1}, {-1, 2.99f, 1}), lamp);
  scene.cameras.push_back(look_at({0, 0, 2.9f}, {0, 0, 0}, {0, 1, 0}, 2 * std::atan(0.45f)));
  return scene;
}

/// A mirror sphere, a glass sphere and twenty matt ones over a checkered floor, two lamps.
inline Scene spheres() {
  Scene scene;
  const auto ball = [&](float radius, Point3 at, const ClassicMaterial& material) {
    Instance instance;
    instance.primitive = int(scene.primitives.size());
    instance.material = test::add_material(scene, material);
    instance.to_world[3] = Vec4(at, 1);
    scene.primitives.push_back(Sphere{radius});
    scene.instances.push_back(instance);
  };
  ball(1, {-1.2f, 1, 0}, {.ka = Rgb(0), .kd = Rgb(0.1f), .ks = Rgb(0.8f), .kr = Rgb(0.8f), .exponent = 100});
  ball(0.8f, {0.9f, 0.8f, 1},
       {.ka = Rgb(0), .kd = Rgb(0), .ks = Rgb(0.5f), .kr = Rgb(0.1f), .kt = Rgb(0.9f), .exponent = 100, .index = 1.5f});
  for (int i = 0; i < 20; ++i) {
    const float a = float(i) * 2.4f, r = 1.5f + 0.13f * float(i);
    const Rgb colour(0.3f + 0.03f * float(i), 0.8f - 0.03f * float(i), 0.4f);
    ball(0.3f, {r * std::cos(a), 0.3f, r * std::sin(a) - 1},
         {.ka = colour, .kd = colour, .ks = Rgb(0.3f), .kr = Rgb(i % 4 ? 0 : 0.3f), .exponent = 40});
  }
  TextureImage checker;
  checker.pixels = Bitmap{2, 2, 3, true, {230, 230, 230, 60, 60, 60, 60, 60, 60, 230, 230, 230}};
  scene.images.push_back(checker);
  const int floor = test::add_matt(scene, Rgb(1));
  scene.materials[size_t(floor)].base_texture.image = 0;
  scene.materials[size_t(floor)].base_texture.filter = Filter::nearest;
  test::add_mesh(scene, test::quad({-100, 0, 100}, {100, 0, 100}, {100, 0, -100}, {-100, 0, -100}), floor);
  scene.meshes.back().uv[0] = {{0, 100}, {100, 100}, {100, 0}, {0, 0}};
  for (const Point3 p : {Point3{4, 6, 5}, {-5, 5, 3}})
    scene.lights.push_back({"lamp", PointLight{p, Intensity(Rgb(120)), {}}, -1});
  scene.ambient = Rgb(0.3f);
  scene.background = Radiance({0.4f, 0.55f, 0.8f});
  scene.cameras.push_back(look_at({0, 2, 6}, {0, 0.6f, 0}, {0, 1, 0}, 0.8f));
  return scene;
}

}  // namespace aktina::bench
