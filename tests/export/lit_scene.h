// A small scene with light on it: two triangles of one quad, and what a solver would say of them.
#pragma once

#include "aktina/radiosity/solution.h"
#include "aktina/scene/scene.h"

namespace aktina::test {

inline Mesh square(const std::string& name, int material) {
  Mesh mesh;
  mesh.name = name;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.material = material;
  return mesh;
}

/// A square on a node of its own, lit as `radiance` (cd/m^2) at its four corners.
inline Scene lit_square(std::array<Rgb, 4> radiance) {
  Scene scene;
  scene.meshes.push_back(square("square", 0));
  for (const Rgb c : radiance) scene.meshes[0].colours.push_back({c.r, c.g, c.b, 1});
  scene.materials.emplace_back();
  scene.materials[0].name = "paint";
  scene.materials[0].unlit = true;
  scene.nodes.push_back({"wall", -1, Mat4(1), Mat4(1)});
  scene.instances.push_back({.mesh = 0, .node = 0});
  return scene;
}

/// `count` quads of 1 m^2 in a row, each with its own vertices; irradiance of patch i is `lux[i]` in all channels.
inline Solution row_of_patches(const std::vector<float>& lux) {
  Solution s;
  for (size_t i = 0; i < lux.size(); ++i) {
    const auto x = float(i);
    const auto first = uint32_t(4 * i);
    for (const Point3 p : {Point3(x, 0, 0), Point3(x + 1, 0, 0), Point3(x + 1, 1, 0), Point3(x, 1, 0)}) {
      s.mesh.positions.push_back(p);
      s.mesh.normals.push_back({0, 0, 1});
      s.mesh.places.push_back({0, 0, 0, 0});
      s.vertex_irradiances.push_back(Irradiance(Rgb(lux[i])));
      s.vertex_radiosities.push_back(Radiosity(Rgb(lux[i] / 2)));
      s.vertex_back_irradiances.emplace_back();
    }
    s.mesh.patches.push_back({first, first + 1, first + 2, first + 3});
    s.mesh.centres.push_back({0, 0, 0.5f, 0});
    s.mesh.areas.push_back(1);
    s.mesh.patch_normals.push_back({0, 0, 1});
    s.mesh.reflectances.push_back(Rgb(0.5f));
    s.mesh.transmittances.push_back(Rgb(0));
    s.mesh.emissions.emplace_back();
    s.mesh.two_sided.push_back(0);
    s.irradiances.push_back(Irradiance(Rgb(lux[i])));
    s.radiosities.push_back(Radiosity(Rgb(lux[i] / 2)));
    s.back_irradiances.emplace_back();
  }
  return s;
}

}  // namespace aktina::test
