// A scene small enough for every method: a lamp above a floor.
#pragma once

#include "aktina/scene/scene.h"

namespace aktina::test {

inline constexpr const char* kRenderMethods[] = {"raster", "whitted", "direct", "path", "radiosity", "two_pass"};

inline Mesh square(const std::string& name, float height, float half, bool up, int material) {
  Mesh mesh;
  mesh.name = name;
  mesh.positions = {{-half, height, half}, {half, height, half}, {half, height, -half}, {-half, height, -half}};
  mesh.normals.assign(4, {0, up ? 1 : -1, 0});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  if (!up)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  mesh.material = material;
  return mesh;
}

/// A grey floor of 4 m x 4 m, and 2 m above it a lamp of 1 m x 1 m and 100 cd/m^2.
inline Scene lit_floor() {
  Scene scene;
  scene.source = "/somewhere/floor.glb";
  scene.materials.resize(2);
  scene.materials[0].base_colour = Rgb(0.5f), scene.materials[0].metallic = 0;
  scene.materials[0].specular_weight = 0;
  scene.materials[1].base_colour = Rgb(0), scene.materials[1].metallic = 0;
  scene.materials[1].emission = Radiance(Rgb(100));
  scene.meshes = {square("floor", 0, 2, true, 0), square("lamp", 2, 0.5f, false, 1)};
  scene.instances = {{.mesh = 0}, {.mesh = 1}};
  scene.cameras.push_back(look_at({0, 3, 6}, {0, 0.5f, 0}, {0, 1, 0}, 0.7f));
  scene.warnings.add("a warning of the import");
  return scene;
}

}  // namespace aktina::test
