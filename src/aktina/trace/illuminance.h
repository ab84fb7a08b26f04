// Light that arrives at points: what a light meter reads there.
#pragma once

#include <span>
#include <vector>

#include "aktina/trace/integrator/integrator.h"
#include "aktina/trace/trace.h"

namespace aktina {

/// Irradiance at points on the side of their normals, lx: lamps, emissive surfaces and sky, directly and by way of
/// other surfaces as far as the integrator follows it.
/// @param points  m, world; a little off surfaces (offset_point). @param normals  unit, as many
/// @param options  integrator, accelerator, samples and seed count. Standard error falls with the root of the samples.
/// @throws Error usage (counts differ), bad_param, no_such_method, limit, cancelled
std::vector<Irradiance> illuminance(const Scene& scene, std::span<const Point3> points, std::span<const Vec3> normals,
                                    const TraceOptions& options = {}, Progress* progress = nullptr);

/// One estimate each.
struct IlluminanceQuery {
  Point3 position;  // off the surface
  Vec3 normal;      // unit
  SampleSequence sequence;
};
void estimate_illuminance(const RayScene& scene, const Integrator& integrator,
                          std::span<const IlluminanceQuery> queries, std::span<Rgb> out, RayCounts& counts);

}  // namespace aktina
