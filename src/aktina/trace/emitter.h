// One thing that shines from somewhere: a triangle, a parallelogram, an analytic shape or a lamp of the scene.
#pragma once

#include "aktina/scene/scene.h"
#include "aktina/trace/light_tree.h"

namespace aktina {

/// A place on an emitter.
struct EmitterSample {
  Point3 position;
  Vec3 normal;  // unit, front
  Vec2 uv[2] = {Vec2(0), Vec2(0)};
  float area_pdf;  // m^-2
};

struct Emitter {
  const Light* lamp = nullptr;           // point or spot; else:
  const Primitive* primitive = nullptr;  // else a triangle
  const Mesh* mesh = nullptr;
  const Material* material = nullptr;
  uint32_t triangle = 0;
  bool parallelogram = false;  // this triangle and the next make one
  Point3 corner{0};            // world
  Vec3 edge[2]{};              // world, from the corner to the next one and to the last one
  Vec3 normal{0};              // of a triangle, unit
  Mat4 to_world{1};            // of a primitive
  float area = 0;              // of a triangle in the world; of a primitive in its own space, m^2

  /// Takes triangle `first` of the mesh, and the next one, too, where they are (a, b, c), (a, c, d) with a + c = b + d.
  void set_triangles(uint32_t first);
  EmitterSample sample(Vec2 u) const;
  /// Of a place that a ray has hit, m^-2. @param normal  as Hit has it: of primitives its length counts
  float area_pdf(Vec3 hit_normal) const;
  /// Radiance, with what lets light through taken off. @param scene  has the textures
  Rgb radiance(const Scene& scene, const Vec2 uv[2]) const;
  /// Averaged over the surface.
  Rgb mean_radiance(const Scene& scene) const;
  LampBounds bounds(const Scene& scene) const;

 private:
  void set_uv(EmitterSample& s, uint32_t t, float b1, float b2) const;
};

}  // namespace aktina
