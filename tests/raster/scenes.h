// Small scenes built in code.
#pragma once

#include <cmath>

#include "aktina/scene/scene.h"

namespace aktina::test {

/// Adds a mesh as an instance of its own. @return  index of the mesh
inline int add_mesh(Scene& scene, Mesh mesh, int material, const Mat4& to_world = Mat4(1)) {
  mesh.material = material;
  scene.meshes.push_back(std::move(mesh));
  Instance instance;
  instance.mesh = int(scene.meshes.size()) - 1;
  instance.to_world = to_world;
  scene.instances.push_back(instance);
  return instance.mesh;
}

inline int add_material(Scene& scene, const ClassicMaterial& classic) {
  scene.materials.push_back(material_of(classic));
  return int(scene.materials.size()) - 1;
}
inline int add_matt(Scene& scene, Rgb kd) { return add_material(scene, {.ka = kd, .kd = kd}); }

/// A flat quadrilateral, counter-clockwise.
inline Mesh quad(Point3 a, Point3 b, Point3 c, Point3 d) {
  Mesh mesh;
  mesh.positions = {a, b, c, d};
  mesh.normals.assign(4, normalize(cross(b - a, d - a)));
  mesh.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A sphere with bumps: r = 1 + height sin(9 phi) sin(7 theta); 2 columns rows triangles.
inline Mesh bumpy_sphere(int columns, int rows, float height = 0.12f) {
  Mesh mesh;
  const auto at = [&](double i, double j) {
    const double phi = i * 2 * kPi / columns, theta = j * kPi / rows;
    const double r = 1 + double(height) * std::sin(9 * phi) * std::sin(7 * theta);
    return Vec3d(r * std::sin(theta) * std::cos(phi), r * std::cos(theta), r * std::sin(theta) * std::sin(phi));
  };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const Vec3d p = at(i, j), du = at(i + 0.01, j) - at(i - 0.01, j), dv = at(i, j + 0.01) - at(i, j - 0.01);
      const Vec3d n = j == 0 || j == rows ? Vec3d(0, j == 0 ? 1 : -1, 0) : -normalize(cross(dv, -du));
      mesh.positions.push_back(p);
      mesh.normals.push_back(dot(n, p) < 0 ? -n : n);
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const auto a = uint32_t(j * (columns + 1) + i), b = a + uint32_t(columns) + 1;
      mesh.triangles.push_back({a, a + 1, b});
      mesh.triangles.push_back({a + 1, b + 1, b});
    }
  return mesh;
}

/// The Cornell box of 1984 in outline, 2 m wide, open towards +z, with an emissive patch below the ceiling.
inline Scene cornell_box() {
  Scene scene;
  const int white = add_matt(scene, Rgb(0.73f)), red = add_matt(scene, {0.63f, 0.06f, 0.05f}),
            green = add_matt(scene, {0.14f, 0.45f, 0.09f}), lamp = add_matt(scene, Rgb(0.78f));
  scene.materials[size_t(lamp)].emission = Radiance({17, 12, 4});
  add_mesh(scene, quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}), white);
  add_mesh(scene, quad({-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1}), white);
  add_mesh(scene, quad({-1, 0, -1}, {1, 0, -1}, {1, 2, -1}, {-1, 2, -1}), white);
  add_mesh(scene, quad({-1, 0, 1}, {-1, 0, -1}, {-1, 2, -1}, {-1, 2, 1}), red);
  add_mesh(scene, quad({1, 0, -1}, {1, 0, 1}, {1, 2, 1}, {1, 2, -1}), green);
  add_mesh(scene, quad({-0.24f, 1.99f, -0.2f}, {0.24f, 1.99f, -0.2f}, {0.24f, 1.99f, 0.2f}, {-0.24f, 1.99f, 0.2f}),
           lamp);
  const int shiny = add_material(scene, {.ka = Rgb(0.1f), .kd = {0.2f, 0.3f, 0.6f}, .ks = Rgb(0.4f), .exponent = 40});
  Mat4 place(0.35f);
  place[3] = {0.4f, 0.35f, 0.3f, 1};
  add_mesh(scene, bumpy_sphere(64, 32), shiny, place);
  const auto box = [&](Point3 low, Point3 high) {
    const auto corner = [&](int i) {
      return Point3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    };
    for (const auto& f : {std::array{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}})
      add_mesh(scene, quad(corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3])), white);
  };
  box({-0.7f, 0, -0.6f}, {-0.1f, 1.2f, 0});
  scene.ambient = Rgb(0.15f);
  scene.cameras.push_back(look_at({0, 1, 4.8f}, {0, 1, 0}, {0, 1, 0}, 0.6f));
  return scene;
}

}  // namespace aktina::test
