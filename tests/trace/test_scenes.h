// Small scenes that the tests of this room share.
#pragma once

#include <cmath>

#include "aktina/scene/scene.h"

namespace aktina::test {

/// Quad a, b, c, d as two triangles, counter-clockwise seen from its front.
inline void add_quad(Mesh& mesh, Point3 a, Point3 b, Point3 c, Point3 d) {
  const auto first = uint32_t(mesh.positions.size());
  for (const Point3 p : {a, b, c, d}) mesh.positions.push_back(p);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

/// Box with outward fronts.
inline Mesh box(Point3 low, Point3 high) {
  Mesh mesh;
  const auto p = [&](int i) { return Point3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z); };
  for (const auto& q : {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    add_quad(mesh, p(q[0]), p(q[1]), p(q[2]), p(q[3]));
  return mesh;
}

/// A closed, bumpy ball of 2 * rings * rings triangles that share vertices.
inline Mesh bumpy_ball(uint32_t rings, float bump = 0.1f) {
  Mesh mesh;
  for (uint32_t j = 0; j <= rings; ++j)
    for (uint32_t i = 0; i < rings; ++i) {
      const float a = float(2 * kPi) * float(i) / float(rings), b = float(kPi) * float(j) / float(rings);
      const bool pole = j % rings == 0;
      const float r = pole ? 1 : 1 + bump * std::sin(9 * a) * std::sin(7 * b), ring = pole ? 0 : r * std::sin(b);
      mesh.positions.push_back({ring * std::cos(a), r * std::cos(b), -ring * std::sin(a)});
    }
  for (uint32_t j = 0; j < rings; ++j)
    for (uint32_t i = 0; i < rings; ++i) {
      const uint32_t a = j * rings + i, b = j * rings + (i + 1) % rings;
      mesh.triangles.push_back({a, a + rings, b});
      mesh.triangles.push_back({b, a + rings, b + rings});
    }
  return mesh;
}

/// Adds the mesh, an instance of it and a material of its own; returns the material to be changed.
inline Material& add(Scene& scene, Mesh mesh, const Mat4& to_world = Mat4(1)) {
  mesh.material = int(scene.materials.size());
  scene.materials.emplace_back();
  scene.materials.back().metallic = 0;
  Instance instance;
  instance.mesh = int(scene.meshes.size());
  instance.to_world = to_world;
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(instance);
  return scene.materials.back();
}
inline Material& add(Scene& scene, const Primitive& primitive, const Mat4& to_world = Mat4(1)) {
  Instance instance;
  instance.primitive = int(scene.primitives.size());
  instance.material = int(scene.materials.size());
  instance.to_world = to_world;
  scene.primitives.push_back(primitive);
  scene.instances.push_back(instance);
  scene.materials.emplace_back();
  scene.materials.back().metallic = 0;
  return scene.materials.back();
}

inline Mat4 translation(Vec3 v) {
  Mat4 m(1);
  m[3] = Vec4(v, 1);
  return m;
}

}  // namespace aktina::test
