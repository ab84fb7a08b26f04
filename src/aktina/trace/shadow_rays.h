// Shadow rays, gathered until there are many, and what arrives along them.
#pragma once

#include <vector>

#include "aktina/base/function_ref.h"
#include "aktina/trace/ray_scene.h"

namespace aktina {

struct ShadowRay {
  Ray ray;
  Rgb light;                    // what arrives if nothing is in between
  uint32_t query;               // whose light it is
  uint32_t ignored = kNothing;  // instance that casts no shadow here: the one that the lamp stands for
  bool first = false;           // the caller's mark
};

/// From a surface to a light, or in a direction.
/// @param from  off the surface already; target  a point, or a direction where `distant`
Ray shadow_ray(Point3 from, Point3 target, bool distant);

class ShadowRays {
 public:
  /// @param clear_bodies  materials with kt attenuate by it, once a body however often it is crossed (Whitted's
  /// method); else they block, and only alpha lets light through
  explicit ShadowRays(bool clear_bodies) : clear_bodies_(clear_bodies) {}

  void add(const ShadowRay& ray) { rays_.push_back(ray); }
  /// Traces all rays, calls `arrived` in the order of add() for those along which some light comes, and forgets them.
  /// @return  rays traced
  size_t trace(const RayScene& scene, Coherence coherence, FunctionRef<void(const ShadowRay& ray)> arrived);

 private:
  void attenuate(const RayScene& scene, ShadowRay& ray) const;
  bool may_pass(const RayScene& scene, const ShadowRay& ray) const;

  bool clear_bodies_;
  std::vector<ShadowRay> rays_;
};

}  // namespace aktina
