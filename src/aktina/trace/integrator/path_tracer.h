// Paths from the eye, many at a time: what the integrators `direct` and `path` are made of.
#pragma once

#include "aktina/trace/integrator/integrator.h"
#include "aktina/trace/shadow_rays.h"

namespace aktina {

/// Which samples of direct light count where both could.
enum class LightStrategy : uint8_t { combined, lights, scattering };

struct PathRules {
  int most_bounces = 64;
  int matt_bounces = 64;  // of those, bounces that are no exact mirroring or refraction
  int roulette = 3;       // bounces before paths may end by chance
  LightStrategy strategy = LightStrategy::combined;
};

/// Waves of rays in packets; paths that have ended leave the wave, shadow rays wait in a dense queue.
class PathTracer {
 public:
  explicit PathTracer(const PathRules& rules) : rules_(rules) {}
  void radiance(const RayScene& scene, std::span<const RadianceQuery> queries, bool coherent,
                std::span<RadianceEstimate> out, RayCounts& counts) const;

 private:
  struct Path;
  struct Wave;
  struct Numbers;
  void gather_sky(Wave& wave, const Path& path) const;
  void gather_emission(Wave& wave, const Path& path, const ShadingPoint& point, const Hit& hit) const;
  void sample_light(Wave& wave, const Path& path, const ShadingPoint& point, const Frame& frame, Vec2 place) const;
  bool scatter(Wave& wave, Path& path, const ShadingPoint& point, const Frame& frame, Vec2 u) const;
  bool survives(Wave& wave, Path& path) const;
  bool advance(Wave& wave, Path& path, const Hit& hit, const Numbers& numbers) const;

  PathRules rules_;
};

std::unique_ptr<Integrator> integrator_by_paths(const PathRules& rules);

}  // namespace aktina
