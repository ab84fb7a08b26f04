// What is drawn: data, no algorithms. World space is in metres, +y up, right-handed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "aktina/base/hash.h"
#include "aktina/base/warnings.h"
#include "aktina/illumination/light/light.h"
#include "aktina/scene/camera.h"
#include "aktina/scene/material.h"
#include "aktina/scene/mesh.h"
#include "aktina/scene/primitive.h"

namespace aktina {

/// A node of the file's hierarchy, parents before children.
struct Node {
  std::string name;
  int parent = -1;
  Mat4 local{1};     // to the parent
  Mat4 to_world{1};  // product down from the root
};

/// A mesh or a primitive, placed.
struct Instance {
  int mesh = -1;       // index into Scene::meshes, or -1
  int primitive = -1;  // index into Scene::primitives, or -1
  int material = -1;   // overrides the mesh's; -1: the mesh's own
  int node = -1;       // index into Scene::nodes
  Mat4 to_world{1};
};

struct PlacedLight {
  std::string name;
  Light light;  // in world space; one with an area stands as a surface instead: place_light() (scene_lights.h)
  int node = -1;
};

/// Radiance from infinity, equirectangular: u = atan2(x, -z) / 2 pi + 1/2, v = acos(y) / pi, turned by `rotation`.
struct EnvironmentLight {
  Image radiance;           // empty: `colour` everywhere
  Radiance colour{Rgb(0)};  // multiplies the image, or stands alone
  float rotation = 0;       // rad about +y
  bool shines() const { return !is_black(colour.v); }
};
Radiance radiance(const EnvironmentLight& light, Vec3 direction);

struct Scene {
  std::vector<Mesh> meshes;
  std::vector<Primitive> primitives;
  std::vector<Material> materials;
  std::vector<TextureImage> images;
  std::vector<Node> nodes;
  std::vector<Instance> instances;
  std::vector<PlacedLight> lights;
  std::vector<Camera> cameras;
  EnvironmentLight environment;
  Rgb ambient{0};       // classic ambient light Ia, as radiance of a white ambient reflector, cd/m^2
  Radiance background;  // what camera rays see beyond everything, where there is no environment

  std::string source;     // file it came from, for reports
  std::string generator;  // program that wrote the file
  double metres_per_unit = 1;
  Warnings warnings;  // what import repaired or guessed

  /// Of an instance, or of its mesh; matt with reflectance 0.8 where neither has one.
  const Material& material_of(const Instance& instance) const;
};

/// Bounds of everything that is drawn, world space.
Bounds bounds(const Scene& scene);
uint64_t triangle_count(const Scene& scene);  // of meshes, instances counted each
/// Hash of everything that affects a picture.
Hash64 hash(const Scene& scene);

/// The documented defaults, where a file has none: a camera that frames the scene; a light (docs/input.md). What was
/// added goes into scene.warnings.
void add_default_camera(Scene& scene);
void add_default_light(Scene& scene);
/// Whether anything shines: lights, environment, emissive surfaces, unlit materials, ambient.
bool has_light(const Scene& scene);

}  // namespace aktina
