// Recursive ray tracing: I = ka Ia + sum over lamps of (kd n.l + ks highlight) Ip + kr S + kt T, S and T from the rays
// in the mirrored and the refracted direction, lamps hidden by what shadow rays meet. (The paper has one ks for S; here
// ks is Phong's highlight and kr the mirror.) Emissive surfaces shine as small lamps in their middle, the sky as
// ambient light. Cost: a shadow ray a lamp and up to two rays a hit, to a fixed depth or until a ray counts for little.
// Weakness: sharp shadows and mirrors only; no light from matt surface to matt surface, no caustics.
//
// T. Whitted, "An Improved Illumination Model for Shaded Display", Comm. ACM 23(6), 1980; cut-off by weight: R. A.
// Hall, D. P. Greenberg, "A Testbed for Realistic Image Synthesis", IEEE CG&A 3(8), 1983.
#include <algorithm>
#include <cmath>

#include "aktina/illumination/model.h"
#include "aktina/scene/scene_lights.h"
#include "aktina/trace/integrator/integrator.h"
#include "aktina/trace/integrator/wave.h"
#include "aktina/trace/offset.h"
#include "aktina/trace/refract.h"
#include "aktina/trace/shadow_rays.h"

namespace aktina {
namespace {

struct Rules {
  int depth;
  float cutoff;        // weight below which no ray is sent
  bool tir_reflects;   // at total internal reflection kt goes to S; else T is black
  bool clear_shadows;  // clear bodies attenuate shadow rays by kt; else they block
  float reach;         // m, distance at which S and T have faded; 0: they do not
};

constexpr uint16_t kMostLayers = 256;  // surfaces that a ray goes straight through by their alpha, at most

/// A node of the tree of rays: its radiance counts `weight` for the query.
struct Node {
  Ray ray;
  Rgb weight;
  uint32_t query;
  uint16_t depth = 0, layers = 0;
};

struct Work {
  const RayScene& scene;
  std::span<RadianceEstimate> out;
  std::vector<Node> nodes;  // yet to be traced
  ShadowRays shadows;

  void add(const Node& node, Rgb light) {
    RadianceEstimate& to = out[node.query];
    (node.depth == 0 ? to.emitted : node.depth == 1 ? to.direct : to.indirect) += node.weight * light;
  }
};

/// The index of the other side over that of the ray's side.
double index_ratio(const ShadingPoint& point) {
  const Material& m = *point.material;
  const double index = std::max(double(m.classic ? m.classic->index : point.surface->ior), 1e-3);
  return point.front ? index : 1 / index;
}

class Whitted final : public Integrator {
 public:
  explicit Whitted(const Rules& rules) : rules_(rules) {}
  void prepare(const RayScene& scene) override { lamps_ = scene_lights(scene.scene); }
  void set_depth_cue(const DepthCue& cue) override { cue_ = cue; }
  void radiance(const RayScene& scene, std::span<const RadianceQuery> queries, bool coherent,
                std::span<RadianceEstimate> out, RayCounts& counts) const override;

 private:
  void advance(Work& work, Node node, const Hit& hit) const;
  void light(Work& work, const Node& node, const ShadingPoint& point) const;
  void branch(Work& work, const Node& node, const ShadingPoint& point) const;
  void send(Work& work, const Node& parent, const ShadingPoint& point, Vec3d direction, Rgb share) const;

  Rules rules_;
  SceneLights lamps_;
  DepthCue cue_;
};

void Whitted::light(Work& work, const Node& node, const ShadingPoint& point) const {
  static const IlluminationModel kModel = Phong{};
  const float cue = cue_.at(point.position);
  for (size_t i = 0; i < lamps_.lights.size(); ++i) {
    const int instance = lamps_.instance[i];
    if (instance == int(point.instance)) continue;
    const LightSample s = sample(lamps_.lights[i], point.position);
    if (!(dot(s.wi, point.geometric) > 0)) continue;
    const Rgb f = brdf_cosine(kModel, *point.surface, point.normal, s.wi, point.wo).total();
    const Rgb arrives = node.weight * f * s.e_perp.v * cue;
    if (is_black(arrives)) continue;
    const Point3 from = offset_point(point.position, point.geometric);
    const bool distant = !(s.distance < kInfinity);
    const Ray ray = shadow_ray(from, distant ? s.wi : point.position + s.wi * s.distance, distant);
    work.shadows.add({ray, arrives, node.query, instance < 0 ? kNothing : uint32_t(instance), node.depth == 0});
  }
}

void Whitted::send(Work& work, const Node& parent, const ShadingPoint& point, Vec3d direction, Rgb share) const {
  Node child;
  child.weight = parent.weight * share;
  if (!(max_channel(child.weight) > 0) || max_channel(child.weight) < rules_.cutoff) return;
  const Vec3 d = direction;
  child.ray = {offset_point(point.position, dot(d, point.geometric) > 0 ? point.geometric : -point.geometric), d};
  child.query = parent.query;
  child.depth = uint16_t(parent.depth + 1);
  work.nodes.push_back(child);
}

void Whitted::branch(Work& work, const Node& node, const ShadingPoint& point) const {
  const Vec3d in = -Vec3d(point.wo), n = point.normal, geometric = point.geometric;
  Rgb mirrored = point.surface->kr;
  if (!is_black(point.surface->kt)) {
    const double ratio = index_ratio(point);
    auto through = refract_direction(in, n, ratio);
    if (through && !(dot(*through, geometric) < 0)) through = refract_direction(in, geometric, ratio);
    if (through)
      send(work, node, point, *through, point.surface->kt);
    else if (rules_.tir_reflects)
      mirrored += point.surface->kt;
  }
  if (is_black(mirrored)) return;
  Vec3d back = reflect_direction(in, n);
  if (!(dot(back, geometric) > 0)) back = reflect_direction(in, geometric);  // bumps turn it into the surface
  send(work, node, point, back, mirrored);
}

void Whitted::advance(Work& work, Node node, const Hit& hit) const {
  const Scene& scene = work.scene.scene;
  if (!hit) {
    work.add(node, scene.environment.shines() ? aktina::radiance(scene.environment, node.ray.direction).v
                                              : scene.background.v);
    return;
  }
  if (rules_.reach > 0 && node.depth > 0) node.weight *= std::max(0.0f, 1 - hit.distance / rules_.reach);
  ShadingPoint point;
  work.scene.surfaces.shade(node.ray, hit, false, point);
  if (point.alpha < 1 && node.layers < kMostLayers) {
    Node beyond = node;
    beyond.weight *= 1 - point.alpha;
    beyond.ray = {offset_point(point.position, -point.geometric), node.ray.direction};
    ++beyond.layers;
    if (max_channel(beyond.weight) > 0 && max_channel(beyond.weight) >= rules_.cutoff) work.nodes.push_back(beyond);
    node.weight *= point.alpha;
    if (is_black(node.weight)) return;
  }
  work.add(node, point.emission.v);
  RadianceEstimate& out = work.out[node.query];
  (node.depth == 0 ? out.direct : out.indirect) += node.weight * point.surface->ka * lamps_.ambient;
  light(work, node, point);
  if (node.depth < rules_.depth) branch(work, node, point);
}

/// Depth first, a batch of rays at a time: memory stays bounded however the trees branch.
void Whitted::radiance(const RayScene& scene, std::span<const RadianceQuery> queries, bool coherent,
                       std::span<RadianceEstimate> out, RayCounts& counts) const {
  Work work{scene, out, {}, ShadowRays(rules_.clear_shadows)};
  std::vector<Node> batch;
  for (uint32_t i = 0; i < queries.size(); ++i) {
    work.nodes.push_back({queries[i].ray, Rgb(1), i, 0, 0});
    out[i] = {};
  }
  while (!work.nodes.empty()) {
    const size_t n = std::min(work.nodes.size(), kBatch);
    batch.assign(work.nodes.end() - std::ptrdiff_t(n), work.nodes.end());
    work.nodes.resize(work.nodes.size() - n);
    counts.rays += n;
    trace_wave(
        *scene.accelerator, n, coherent ? Coherence::coherent : Coherence::incoherent,
        [&](size_t i) { return batch[i].ray; },
        [&](size_t first, int count, const HitPacket& hits) {
          for (int lane = 0; lane < count; ++lane) advance(work, batch[first + size_t(lane)], hits.at(lane));
        });
    counts.shadow_rays += work.shadows.trace(scene, Coherence::incoherent, [&](const ShadowRay& ray) {
      (ray.first ? out[ray.query].direct : out[ray.query].indirect) += ray.light;
    });
  }
}

constexpr Param kParams[] = {
    {"depth", "1", "reflections and refractions in a row", 8, 0, 64, true},
    {"cutoff", "1", "weight below which no ray is sent: Hall's adaptive depth", 0.002, 0, 1},
    {"tir", "1", "at total internal reflection 1: kt goes to the mirrored ray, 0: the refracted ray is black", 1, 0, 1,
     true},
    {"shadows", "1", "of clear bodies 1: attenuated by kt once a body, 0: black", 1, 0, 1, true},
    {"reach", "m", "distance at which mirrored and refracted light has faded away, in proportion; 0: it does not fade",
     0, 0, 1e9},
};

}  // namespace

extern constinit const Method<std::unique_ptr<Integrator>> whitted_integrator = {
    {"whitted", "Recursive ray tracing", "whitted1980",
     "Mirrors, refraction and sharp shadows from one ray a pixel; matt surfaces do not light each other.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<Integrator> {
      return std::make_unique<Whitted>(
          Rules{int(p["depth"]), float(p["cutoff"]), p["tir"] == 1, p["shadows"] == 1, float(p["reach"])});
    }};

}  // namespace aktina
