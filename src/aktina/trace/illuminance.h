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

/// Until when light is gathered.
struct MeasureOptions {
  std::string integrator = "path", accelerator{};  // as in TraceOptions
  double target_error = 0.01;                      // wanted standard error over the average: root mean square of points
  int most_samples = 1 << 16;                      // a point
  uint32_t seed = 0;
};

struct Measurement {
  std::vector<double> lux;              // luminance-weighted; NaN at points inside of closed bodies
  std::vector<double> standard_errors;  // lx
  int samples = 0;                      // a point
  double error = 0;                     // as target_error
  bool reached = false;                 // the target
  uint64_t inside = 0;                  // points inside of bodies
};

/// Illuminance at points, in rounds of independently scrambled sequences whose spread tells the error, until the target
/// is reached. Points lie inside of a body where the way up and the way down first meet the back of a surface.
/// A cancelled run returns what it has from the second round on. @throws Error as illuminance()
Measurement measure_illuminance(const Scene& scene, std::span<const Point3> points, std::span<const Vec3> normals,
                                const MeasureOptions& options = {}, Progress* progress = nullptr);

/// One estimate each.
struct IlluminanceQuery {
  Point3 position;  // off the surface
  Vec3 normal;      // unit
  SampleSequence sequence;
};
void estimate_illuminance(const RayScene& scene, const Integrator& integrator,
                          std::span<const IlluminanceQuery> queries, std::span<Rgb> out, RayCounts& counts);

/// Adds samples [first, last) of points [begin, end) up: sums[i - begin] is that of point i.
void sum_illuminance(const RayScene& scene, const Integrator& integrator, std::span<const Point3> points,
                     std::span<const Vec3> normals, size_t begin, size_t end, int first, int last, uint32_t seed,
                     std::span<Rgb> sums);

}  // namespace aktina
