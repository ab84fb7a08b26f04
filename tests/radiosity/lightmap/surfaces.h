// Surfaces that are laid out in lightmaps.
#pragma once

#include <cmath>

#include "aktina/radiosity/lightmap/surface.h"
#include "aktina/radiosity/solve.h"
#include "aktina/scene/mesh.h"
#include "radiosity/scenes.h"

namespace aktina::test {

/// A sphere of triangles, its front outside, smooth.
inline Mesh ball(int rings, float radius = 1) {
  Mesh mesh;
  const int around = 2 * rings;
  for (int r = 0; r <= rings; ++r)
    for (int a = 0; a < around; ++a) {
      const double theta = kPi * r / rings, phi = 2 * kPi * a / around;
      mesh.positions.push_back(
          radius * Vec3(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi)));
      if (r == 0 || r == rings) mesh.positions.back() = {0, r == 0 ? radius : -radius, 0};
      mesh.normals.push_back(normalize(mesh.positions.back()));
    }
  const auto id = [&](int r, int a) { return uint32_t(r * around + a % around); };
  for (int r = 0; r < rings; ++r)
    for (int a = 0; a < around; ++a) {
      if (r > 0) mesh.triangles.push_back({id(r, a), id(r + 1, a), id(r, a + 1)});
      if (r + 1 < rings) mesh.triangles.push_back({id(r, a + 1), id(r + 1, a), id(r + 1, a + 1)});
    }
  return mesh;
}

/// A ramp that winds upwards `turns` times: seen from above it lies upon itself.
inline Mesh helix(double turns, int steps) {
  Mesh mesh;
  for (int i = 0; i <= steps; ++i) {
    const double phi = 2 * kPi * turns * i / steps, height = 0.3 * turns * i / steps;
    for (const double radius : {1.0, 2.0})
      mesh.positions.emplace_back(radius * std::cos(phi), height, -radius * std::sin(phi));
  }
  for (uint32_t i = 0; i < uint32_t(steps); ++i) {
    mesh.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 3});
    mesh.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 2});
  }
  generate_normals(mesh, 1);
  return mesh;
}

/// Only the mesh, and patches without light on it.
struct BareSolution {
  Scene scene;
  Solution solution;
};
inline BareSolution bare(Mesh mesh, bool two_sided = false) {
  BareSolution out;
  out.scene.materials.emplace_back();
  out.scene.materials[0].double_sided = two_sided;
  out.scene.materials[0].metallic = 0;
  mesh.material = 0;
  out.scene.meshes.push_back(std::move(mesh));
  out.scene.instances.push_back({.mesh = 0});
  out.solution.mesh.patches.push_back({0, 0, 0, 0});
  out.solution.mesh.centres.push_back({0, 0, 0, 0});
  out.solution.mesh.two_sided.push_back(two_sided);
  return out;
}
inline LightmapSurface surface_of_mesh(Mesh mesh) {
  const BareSolution b = bare(std::move(mesh));
  return lightmap_surfaces(b.scene, b.solution)[0];
}

}  // namespace aktina::test
