#include "aktina/trace/radiance.h"

#include <fmt/core.h>

#include <algorithm>
#include <mutex>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"

namespace aktina {
namespace {
constexpr int kMostSamples = 1 << 24;
}

void check_samples(int samples) {
  if (samples < 1 || samples > kMostSamples)
    throw Error(Code::bad_param, "trace.samples", fmt::format("got {}", samples),
                fmt::format("accepted 1 .. {}", kMostSamples));
}

std::unique_ptr<Integrator> make_integrator(const RayScene& scene, const TraceOptions& options) {
  auto integrator = make_method(integrators(), "integrator", options.integrator);
  check(options.depth_cue);
  if (options.depth_cue.active()) integrator->set_depth_cue(options.depth_cue);
  integrator->prepare(scene);
  return integrator;
}

void sample_batches(size_t items, const TraceOptions& options, Progress* progress,
                    FunctionRef<void(size_t, size_t, int, int)> body) {
  check_samples(options.samples);
  const int together = std::min(options.samples, int(kBatch));
  const size_t grain = std::max<size_t>(kBatch / size_t(together), 1);
  if (progress) progress->begin("tracing", "rays", items);
  parallel_for(items, grain, [&](size_t begin, size_t end) {
    for (int first = 0; first < options.samples; first += together) {
      if (progress) progress->throw_if_cancelled();
      body(begin, end, first, std::min(first + together, options.samples));
    }
    if (progress) progress->advance(end - begin);
  });
}

std::vector<Radiance> trace_radiance(const Scene& scene, std::span<const Ray> rays, const TraceOptions& options,
                                     Progress* progress, TraceStatistics* statistics) {
  for (size_t i = 0; i < rays.size(); ++i)
    if (!(squared_length(rays[i].direction) > 0) || !is_finite(rays[i].direction) || !is_finite(rays[i].origin))
      throw Error(Code::usage, fmt::format("rays[{}]", i), "a ray needs an origin and a direction");
  const RayScene prepared(scene, options.accelerator);
  const auto integrator = make_integrator(prepared, options);
  std::vector<Radiance> result(rays.size());
  std::mutex mutex;
  TraceStatistics sum;
  sample_batches(rays.size(), options, progress, [&](size_t begin, size_t end, int first, int last) {
    std::vector<RadianceQuery> queries;
    for (size_t i = begin; i < end; ++i) {
      Ray ray = rays[i];
      const float size = length(ray.direction);
      ray.direction /= size, ray.near *= size, ray.far *= size;
      for (int s = first; s < last; ++s)
        queries.push_back({ray, {hash_combine(options.seed, hash32(uint32_t(i))), uint32_t(s)}});
    }
    std::vector<RadianceEstimate> estimates(queries.size());
    RayCounts counts;
    integrator->radiance(prepared, queries, false, estimates, counts);
    uint64_t not_finite = 0;
    for (size_t i = begin, k = 0; i < end; ++i)
      for (int s = first; s < last; ++s, ++k) {
        const Rgb light = estimates[k].total() / float(options.samples);
        is_finite(light) ? void(result[i].v += light) : void(++not_finite);
      }
    const std::lock_guard lock(mutex);
    sum.rays += counts.rays, sum.shadow_rays += counts.shadow_rays, sum.not_finite += not_finite;
  });
  sum.samples = options.samples;
  if (statistics) *statistics = sum;
  return result;
}

}  // namespace aktina
