// Scenes that radiosity is tested on.
#pragma once

#include "aktina/scene/scene.h"

namespace aktina {

/// Adds a parallelogram of its own mesh and material; its front is towards u x v. Returns its instance.
inline size_t add_quad(Scene& scene, Point3 corner, Vec3 u, Vec3 v, Rgb reflectance, Rgb exitance = Rgb(0)) {
  Mesh mesh;
  mesh.positions = {corner, corner + u, corner + u + v, corner + v};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.normals.assign(4, normalize(cross(u, v)));
  mesh.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.material = int(scene.materials.size());
  Material material;
  material.base_colour = reflectance;
  material.metallic = 0, material.roughness = 1, material.specular_weight = 0;
  material.emission = lambertian_radiance(Radiosity(exitance));
  scene.materials.push_back(material);
  Instance instance;
  instance.mesh = int(scene.meshes.size());
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(instance);
  return scene.instances.size() - 1;
}

/// The inside of the box [0, size]: floor y = 0, ceiling, then x = 0, x = size.x, z = 0, z = size.z.
inline Scene room(Vec3 size, Rgb reflectance, Rgb exitance = Rgb(0)) {
  Scene scene;
  const Vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  add_quad(scene, Point3(0), z, x, reflectance, exitance);
  add_quad(scene, y, x, z, reflectance, exitance);
  add_quad(scene, Point3(0), y, z, reflectance, exitance);
  add_quad(scene, x, z, y, reflectance, exitance);
  add_quad(scene, Point3(0), x, y, reflectance, exitance);
  add_quad(scene, z, y, x, reflectance, exitance);
  return scene;
}

/// A box standing in it, its front outside.
inline void add_box(Scene& scene, Point3 low, Vec3 size, Rgb reflectance, Rgb exitance = Rgb(0)) {
  const Vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  add_quad(scene, low + y, z, x, reflectance, exitance);
  add_quad(scene, low, x, z, reflectance, exitance);
  add_quad(scene, low, z, y, reflectance, exitance);
  add_quad(scene, low + x, y, z, reflectance, exitance);
  add_quad(scene, low, y, x, reflectance, exitance);
  add_quad(scene, low + z, x, y, reflectance, exitance);
}

}  // namespace aktina
