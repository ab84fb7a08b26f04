// What an integrator does: radiance along rays. Virtual per batch of rays, never per ray.
#pragma once

#include <memory>
#include <span>

#include "aktina/base/method.h"
#include "aktina/illumination/illuminate.h"
#include "aktina/trace/ray_scene.h"
#include "aktina/trace/sampler.h"

namespace aktina {

/// A ray along which radiance is asked for.
struct RadianceQuery {
  Ray ray;  // direction of unit length
  SampleSequence sequence;
};

/// What comes along it, cd/m^2.
struct RadianceEstimate {
  Rgb emitted;   // by what the ray meets, or by the sky
  Rgb direct;    // scattered once
  Rgb indirect;  // scattered more often
  Rgb total() const { return emitted + direct + indirect; }
};

struct RayCounts {
  uint64_t rays = 0, shadow_rays = 0;
  RayCounts& operator+=(const RayCounts& o) { return rays += o.rays, shadow_rays += o.shadow_rays, *this; }
};

class Integrator {
 public:
  virtual ~Integrator() = default;
  /// Called once, before radiance().
  virtual void prepare(const RayScene& /*scene*/) {}
  /// Called before, where depth cueing is asked for. @throws Error usage from methods that have none
  virtual void set_depth_cue(const DepthCue& cue);
  /// One estimate for each query; the same queries give the same estimates. From any thread.
  /// @param coherent  neighbouring rays go together
  virtual void radiance(const RayScene& scene, std::span<const RadianceQuery> queries, bool coherent,
                        std::span<RadianceEstimate> out, RayCounts& counts) const = 0;
};

/// Queries a call is best given: enough for dense packets after some bounces, few enough for the cache.
inline constexpr size_t kBatch = 2048;

std::span<const Method<std::unique_ptr<Integrator>>* const> integrators();

}  // namespace aktina
