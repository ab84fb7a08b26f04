#include "aktina/trace/illuminance.h"

#include <fmt/core.h>

#include <atomic>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/trace/radiance.h"
#include "aktina/trace/shadow_rays.h"

namespace aktina {
namespace {

constexpr uint32_t kOwnSeed = 0x1f83d9abU;  // apart from the numbers of the ray that follows
enum Dimension : uint32_t { kLampChoice, kLampPlace, kDirection };

/// A direction of cosine density, and the radiance from there but for what shines by itself.
RadianceQuery gathering_ray(const IlluminanceQuery& q, const SampleSequence& own) {
  const Vec3 local = sample_cosine_hemisphere(own.pair(kDirection));
  return {{q.position, normalize(Frame(q.normal).to_world(local))}, q.sequence};
}

}  // namespace

/// E = (sampled lamps) + pi times the mean of what other surfaces send.
void estimate_illuminance(const RayScene& scene, const Integrator& integrator,
                          std::span<const IlluminanceQuery> queries, std::span<Rgb> out, RayCounts& counts) {
  std::vector<RadianceQuery> gather;
  ShadowRays shadows(false);
  for (uint32_t i = 0; i < queries.size(); ++i) {
    const IlluminanceQuery& q = queries[i];
    out[i] = Rgb(0);
    const SampleSequence own{q.sequence.seed ^ kOwnSeed, q.sequence.index};
    gather.push_back(gathering_ray(q, own));
    const ArrivingLight light = scene.lights.sample(q.position, own.single(kLampChoice), own.pair(kLampPlace));
    const float cosine = dot(light.wi, q.normal);
    if (is_black(light.e_perp) || !(cosine > 0)) continue;
    shadows.add({shadow_ray(q.position, light.target, light.distant), light.e_perp * cosine, i});
  }
  std::vector<RadianceEstimate> around(queries.size());
  integrator.radiance(scene, gather, false, around, counts);
  for (size_t i = 0; i < queries.size(); ++i) out[i] = (around[i].direct + around[i].indirect) * float(kPi);
  counts.shadow_rays +=
      shadows.trace(scene, Coherence::incoherent, [&](const ShadowRay& ray) { out[ray.query] += ray.light; });
}

void sum_illuminance(const RayScene& scene, const Integrator& integrator, std::span<const Point3> points,
                     std::span<const Vec3> normals, size_t begin, size_t end, int first, int last, uint32_t seed,
                     std::span<Rgb> sums) {
  std::vector<IlluminanceQuery> queries;
  for (size_t i = begin; i < end; ++i)
    for (int s = first; s < last; ++s)
      queries.push_back({points[i], normals[i], {hash_combine(seed, hash32(uint32_t(i))), uint32_t(s)}});
  std::vector<Rgb> estimates(queries.size());
  RayCounts counts;
  estimate_illuminance(scene, integrator, queries, estimates, counts);
  for (size_t i = begin, k = 0; i < end; ++i)
    for (int s = first; s < last; ++s) sums[i - begin] += estimates[k++];
}

std::vector<Irradiance> illuminance(const Scene& scene, std::span<const Point3> points, std::span<const Vec3> normals,
                                    const TraceOptions& options, Progress* progress) {
  if (points.size() != normals.size())
    throw Error(Code::usage, "illuminance", fmt::format("{} points but {} normals", points.size(), normals.size()));
  const RayScene prepared(scene, options.accelerator);
  const auto integrator = make_integrator(prepared, options);
  std::vector<Irradiance> result(points.size());
  sample_batches(points.size(), options, progress, [&](size_t begin, size_t end, int first, int last) {
    std::vector<Rgb> sums(end - begin);
    sum_illuminance(prepared, *integrator, points, normals, begin, end, first, last, options.seed, sums);
    for (size_t i = begin; i < end; ++i) result[i].v += sums[i - begin] / float(options.samples);
  });
  return result;
}

}  // namespace aktina
