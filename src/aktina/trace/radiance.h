// Radiance along rays of any origin, and what the fronts of this room share.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "aktina/base/function_ref.h"
#include "aktina/trace/integrator/integrator.h"
#include "aktina/trace/trace.h"

namespace aktina {

/// Radiance that arrives at the origins of rays from the directions that they go to, cd/m^2.
/// @param rays  directions of any length but zero
/// @param options  integrator, accelerator, samples and seed count
/// @throws Error usage (a direction without length), bad_param, no_such_method, limit, cancelled
std::vector<Radiance> trace_radiance(const Scene& scene, std::span<const Ray> rays, const TraceOptions& options = {},
                                     Progress* progress = nullptr, TraceStatistics* statistics = nullptr);

/// The integrator that the options name, prepared. @throws Error no_such_method, bad_param
std::unique_ptr<Integrator> make_integrator(const RayScene& scene, const TraceOptions& options);

/// Calls body(begin, end, first sample, last sample) in parallel for pieces of `items`, each piece with its samples in
/// order. @throws Error cancelled, bad_param (samples)
void sample_batches(size_t items, const TraceOptions& options, Progress* progress,
                    FunctionRef<void(size_t, size_t, int, int)> body);

/// @throws Error bad_param
void check_samples(int samples);

}  // namespace aktina
