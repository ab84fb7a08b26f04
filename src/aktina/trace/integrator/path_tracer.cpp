#include "aktina/trace/integrator/path_tracer.h"

#include <algorithm>

#include "aktina/trace/integrator/wave.h"
#include "aktina/trace/offset.h"

namespace aktina {
namespace {

constexpr int kMostLayers = 256;  // surfaces that a path goes straight through by their alpha, at most

// Dimensions of a path's random numbers: 0 is the camera's, then kPerBounce a bounce.
enum Dimension : uint32_t { kLampChoice = 1, kLampPlace, kDirection, kLobe, kRoulette, kAlpha, kPerBounce };

/// Veach & Guibas 1995: the power heuristic.
float mis_weight(float own, float other) {
  const float ratio = other / own;  // squares would overflow
  return 1 / (1 + ratio * ratio);
}

}  // namespace

struct PathTracer::Path {
  Ray ray;
  Rgb throughput{1};
  Point3 vertex;  // where it was scattered last
  float pdf = 0;  // sr^-1, of its direction; 0: exact
  uint32_t query;
  uint16_t bounces = 0, matt_bounces = 0, layers = 0;
  uint32_t dimension(Dimension d) const { return uint32_t(bounces) * kPerBounce + d; }
};

/// The random numbers of one bounce that are worth spreading well.
struct PathTracer::Numbers {
  Vec2 lamp_place, direction;
};

struct PathTracer::Wave {
  const RayScene& scene;
  std::span<const RadianceQuery> queries;
  std::span<RadianceEstimate> out;
  ShadowRays shadows{false};

  const SampleSequence& sequence(const Path& path) const { return queries[path.query].sequence; }
  void add(uint32_t query, int bounces, Rgb light) {
    RadianceEstimate& to = out[query];
    (bounces == 0 ? to.emitted : bounces == 1 ? to.direct : to.indirect) += light;
  }
};

/// Light of the sky; the backdrop of scenes without one is seen directly and in mirrors, and lights nothing.
void PathTracer::gather_sky(Wave& wave, const Path& path) const {
  const EnvironmentLight& sky = wave.scene.scene.environment;
  if (!sky.shines()) {
    if (path.matt_bounces == 0) wave.add(path.query, path.bounces, path.throughput * wave.scene.scene.background.v);
    return;
  }
  float weight = 1;
  if (path.pdf > 0) {
    if (rules_.strategy == LightStrategy::lights) return;
    if (rules_.strategy == LightStrategy::combined)
      weight = mis_weight(path.pdf, wave.scene.lights.sky_pdf(path.ray.direction));
  }
  wave.add(path.query, path.bounces, path.throughput * aktina::radiance(sky, path.ray.direction).v * weight);
}

void PathTracer::gather_emission(Wave& wave, const Path& path, const ShadingPoint& point, const Hit& hit) const {
  if (is_black(point.emission.v)) return;
  if (point.material->unlit && path.matt_bounces > 0) return;
  float weight = 1;
  if (path.pdf > 0) {
    if (rules_.strategy == LightStrategy::lights) return;
    if (rules_.strategy == LightStrategy::combined)
      weight = mis_weight(path.pdf, wave.scene.lights.pdf(path.vertex, hit, length(point.position - path.vertex),
                                                          dot(point.geometric, point.wo)));
  }
  wave.add(path.query, path.bounces, path.throughput * point.emission.v * weight);
}

void PathTracer::sample_light(Wave& wave, const Path& path, const ShadingPoint& point, const Frame& frame,
                              Vec2 place) const {
  if (point.scattering->only_smooth() || wave.scene.lights.empty()) return;
  const LightSampler& lights = wave.scene.lights;
  const float choice = lights.only_one() ? 0 : wave.sequence(path).single(path.dimension(kLampChoice));
  const ArrivingLight light = lights.sample(point.position, choice, place);
  if (is_black(light.e_perp)) return;
  if (light.pdf > 0 && rules_.strategy == LightStrategy::scattering) return;
  const Vec3 wi = frame.to_local(light.wi);
  const float side = dot(light.wi, point.geometric);
  if (!(side * wi.z > 0)) return;
  const ScatterValue f = point.scattering->eval(frame.to_local(point.wo), wi, !point.front);
  const float weight = light.pdf > 0 && rules_.strategy == LightStrategy::combined ? mis_weight(light.pdf, f.pdf) : 1;
  const Rgb arrives = path.throughput * f.value * light.e_perp * weight;
  if (is_black(arrives)) return;
  const Point3 from = offset_point(point.position, side > 0 ? point.geometric : -point.geometric);
  wave.shadows.add({shadow_ray(from, light.target, light.distant), arrives, path.query, kNothing, path.bounces == 0});
}

bool PathTracer::survives(Wave& wave, Path& path) const {
  if (is_black(path.throughput)) return false;
  if (path.bounces < rules_.roulette) return true;
  const float chance = std::min(max_channel(path.throughput), 0.95f);
  if (wave.sequence(path).random(path.dimension(kRoulette)) >= chance) return false;
  path.throughput *= 1 / chance;
  return true;
}

bool PathTracer::scatter(Wave& wave, Path& path, const ShadingPoint& point, const Frame& frame, Vec2 u) const {
  const float lobe = wave.sequence(path).random(path.dimension(kLobe));
  const ScatterSample s = point.scattering->sample(frame.to_local(point.wo), u, lobe, !point.front);
  if (is_black(s.weight)) return false;
  const Vec3 wi = frame.to_world(s.wi);
  const float side = dot(wi, point.geometric);
  if (!(side * s.wi.z > 0)) return false;
  path.throughput *= s.weight;
  path.vertex = point.position;
  path.pdf = s.pdf;
  path.ray = {offset_point(point.position, side > 0 ? point.geometric : -point.geometric),
              normalize_or(wi, point.normal)};
  ++path.bounces;
  if (s.pdf > 0) ++path.matt_bounces;
  return survives(wave, path);
}

/// One hit of one path. @return  whether the path goes on
bool PathTracer::advance(Wave& wave, Path& path, const Hit& hit, const Numbers& numbers) const {
  if (!hit) {
    gather_sky(wave, path);
    return false;
  }
  ShadingPoint point;
  wave.scene.surfaces.shade(path.ray, hit, true, point);
  if (point.alpha < 1 && wave.sequence(path).random(path.dimension(kAlpha) + 131 * path.layers) >= point.alpha) {
    path.ray.origin = offset_point(point.position, -point.geometric);
    path.ray.near = 0;
    return ++path.layers < kMostLayers;
  }
  gather_emission(wave, path, point, hit);
  if (path.bounces >= rules_.most_bounces || path.matt_bounces >= rules_.matt_bounces) return false;
  if (point.scattering->black()) return false;
  const Frame frame(point.normal);
  sample_light(wave, path, point, frame, numbers.lamp_place);
  return scatter(wave, path, point, frame, numbers.direction);
}

void PathTracer::radiance(const RayScene& scene, std::span<const RadianceQuery> queries, bool coherent,
                          std::span<RadianceEstimate> out, RayCounts& counts) const {
  Wave wave{scene, queries, out};
  std::vector<Path> paths(queries.size());
  for (uint32_t i = 0; i < queries.size(); ++i) paths[i].ray = queries[i].ray, paths[i].query = i, out[i] = {};
  Coherence coherence = coherent ? Coherence::coherent : Coherence::incoherent;
  while (!paths.empty()) {
    size_t alive = 0;
    counts.rays += paths.size();
    trace_wave(
        *scene.accelerator, paths.size(), coherence, [&](size_t i) { return paths[i].ray; },
        [&](size_t first, int n, const HitPacket& hits) {
          SequencePacket sequences;
          for (int k = 0; k < n; ++k) {
            const Path& path = paths[first + size_t(k)];
            sequences.set(k, wave.sequence(path), path.dimension(Dimension(0)));
          }
          PairPacket place, direction;
          sample_pairs(sequences, kLampPlace, place), sample_pairs(sequences, kDirection, direction);
          for (int k = 0; k < n; ++k) {
            Path& path = paths[first + size_t(k)];
            if (advance(wave, path, hits.at(k), {place.at(k), direction.at(k)})) paths[alive++] = path;
          }
        });
    paths.resize(alive);
    counts.shadow_rays += wave.shadows.trace(
        scene, Coherence::incoherent, [&](const ShadowRay& ray) { wave.add(ray.query, ray.first ? 1 : 2, ray.light); });
    coherence = Coherence::incoherent;
  }
}

namespace {

class PathIntegrator final : public Integrator {
 public:
  explicit PathIntegrator(const PathRules& rules) : tracer_(rules) {}
  void radiance(const RayScene& scene, std::span<const RadianceQuery> queries, bool coherent,
                std::span<RadianceEstimate> out, RayCounts& counts) const override {
    tracer_.radiance(scene, queries, coherent, out, counts);
  }

 private:
  PathTracer tracer_;
};

}  // namespace

std::unique_ptr<Integrator> integrator_by_paths(const PathRules& rules) {
  return std::make_unique<PathIntegrator>(rules);
}

}  // namespace aktina
