// What rays find: the geometry and the material of a hit, prepared once a scene.
#pragma once

#include <optional>
#include <vector>

#include "aktina/scene/scene.h"
#include "aktina/trace/placed_primitive.h"
#include "aktina/trace/ray.h"
#include "aktina/trace/scattering.h"

namespace aktina {

/// A point of a surface, seen along a ray.
struct ShadingPoint {
  Point3 position;  // world; within a few roundings of the surface
  Vec3 wo;          // unit, back along the ray
  Vec3 geometric;   // unit, on wo's side
  Vec3 normal;      // unit, interpolated and bumped, on wo's side
  bool front;       // wo is on the front side
  uint32_t instance, triangle;
  float alpha;             // opacity: 1 solid, 0 not there
  Radiance emission;       // towards wo
  const Surface* surface;  // coefficients
  const Scattering* scattering;
  const Material* material;

  ShadingPoint() = default;
  ShadingPoint(const ShadingPoint&) = delete;
  ShadingPoint& operator=(const ShadingPoint&) = delete;

 private:
  friend class SurfaceTable;
  std::optional<MaterialPoint> own_;  // where textures or vertex colours make it differ from the material's
  std::optional<Scattering> own_scattering_;
};

class SurfaceTable {
 public:
  /// `scene` must outlive this. @throws Error bad_input (an index beyond the vertices, images or materials)
  explicit SurfaceTable(const Scene& scene);

  /// Interpolated normals that lean away from the viewer are turned back to it, so that wo is above both normals.
  /// @param scatters  fill `scattering`, too
  void shade(const Ray& ray, const Hit& hit, bool scatters, ShadingPoint& out) const;
  /// Opacity alone: for shadow rays.
  float alpha(const Ray& ray, const Hit& hit) const;
  /// Share of light that clear bodies let pass, Whitted's kt: for his shadow rays.
  Rgb transmission(const Ray& ray, const Hit& hit) const;
  /// Whether some surface lets light straight through (alpha).
  bool any_alpha() const { return any_alpha_; }
  /// Whether the instance's material can have an alpha below 1.
  bool has_alpha(uint32_t instance) const { return placed_[instance].has_alpha; }
  const Material& material(uint32_t instance) const { return *placed_[instance].material; }

 private:
  struct Placed {
    const Mesh* mesh = nullptr;
    std::optional<PlacedPrimitive> primitive;
    const Material* material = nullptr;
    Mat4 to_world{1};
    Mat3 normal_to_world{1};
    bool plain = true;  // the same coefficients everywhere
    bool has_alpha = false;
    MaterialPoint point;  // of plain ones
    std::optional<Scattering> scattering;
  };
  struct Local;
  MaterialPoint material_point(const Placed& placed, const Ray& ray, const Hit& hit) const;
  Local locate(const Placed& placed, const Ray& ray, const Hit& hit) const;
  Point3 position(const Placed& placed, const Ray& ray, const Hit& hit) const;
  Vec3 bumped(const Placed& placed, const Hit& hit, const Local& local, Vec3 normal) const;

  const Scene* scene_;
  std::vector<Placed> placed_;
  bool any_alpha_ = false;
};

}  // namespace aktina
