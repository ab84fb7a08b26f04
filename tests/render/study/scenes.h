// Scenes small enough to study in a moment.
#pragma once

#include "aktina/render/study/surface_grid.h"
#include "aktina/scene/scene.h"

namespace aktina::test {

inline Scene shiny(Mesh mesh) {
  Scene scene;
  scene.source = "/somewhere/ball.glb";
  scene.materials.push_back(material_of({.ka = Rgb(0.1f), .kd = {0.6f, 0.4f, 0.2f}, .ks = Rgb(0.5f), .exponent = 20}));
  mesh.material = 0;
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back({.mesh = 0});
  scene.lights.push_back({"lamp", PointLight{{2, 3, 4}, Intensity(Rgb(40)), {}}, -1});
  scene.cameras.push_back(look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 0.6f));
  return scene;
}

inline Scene ball(int columns = 12, int rows = 8) {
  Mesh mesh;
  add_grid(mesh, columns, rows, [](double u, double v) {
    const double a = 2 * kPi * u, b = kPi * v;
    const Vec3d p(std::sin(b) * std::sin(a), std::cos(b), std::sin(b) * std::cos(a));
    return SurfacePoint3{p, p};
  });
  return shiny(std::move(mesh));
}

}  // namespace aktina::test
