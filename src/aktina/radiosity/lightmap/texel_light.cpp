// From the solution: its values at vertices, in between linear. By rays: direct light of lamps, emitters and sky,
// places spread over the texel, so that edges of shadows are as sharp as texels are and no sharper; and final gather,
// rays in all directions that see the solution where they end.
//
// M. Reichert, "A Two-Pass Radiosity Method Driven by Lights and Viewer Position", Master's thesis, Cornell 1992; D.
// Lischinski, F. Tampieri, D. Greenberg, "Combining Hierarchical Radiosity and Discontinuity Meshing", SIGGRAPH 1993
// (both: what arrives at the last surface is gathered anew).
#include "aktina/radiosity/lightmap/texel_light.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "aktina/base/parallel.h"
#include "aktina/radiosity/display/patch_scene.h"
#include "aktina/radiosity/lightmap/page_index.h"
#include "aktina/radiosity/lightmap/patch_locator.h"
#include "aktina/trace/offset.h"
#include "aktina/trace/ray_scene.h"
#include "aktina/trace/sampler.h"
#include "aktina/trace/shadow_rays.h"

namespace aktina {
namespace {

constexpr size_t kGrain = 256;    // texels
constexpr float kPullIn = 0.05f;  // texels: samples keep this far from the edges of triangles, where other walls stand
constexpr uint32_t kMostLayers = 64;
enum Dimension : uint32_t { kWithin, kLampChoice, kLampPlace, kDirection, kAlpha };

/// Sums over the samples of one texel.
struct Samples {
  Rgb sum;
  double squares = 0;
  void add(Rgb value) {
    sum += value;
    squares += double(luminance(value)) * double(luminance(value));
  }
  float variance_of_mean(int n) const {
    const double mean = double(luminance(sum)) / n;
    return n > 1 ? float(std::max(0.0, squares / n - mean * mean) / (n - 1)) : 0;
  }
};

class Lighting {
 public:
  Lighting(const Scene& scene, const Solution& solution, const LightmapLayout& layout,
           std::span<const LightmapTexel> texels, const LightmapOptions& options)
      : solution_(solution), layout_(layout), texels_(texels), options_(options), locator_(solution.mesh) {
    if (options.direct_samples > 0) rays_.emplace(scene, "");
    if (options.gather_samples > 0) {
      patches_ = std::make_unique<PatchScene>(scene, solution);
      patch_rays_.emplace(patches_->scene, "");
    }
  }

  void run(size_t begin, size_t end, TexelLight& out) const {
    from_solution(begin, end, out);
    if (rays_)
      for (size_t i = begin; i < end; ++i) out.buried[i] = buried(i);
    if (rays_) add(begin, end, out, options_.direct_samples, [&](size_t i, auto& s) { sample_direct(i, s); });
    if (patch_rays_) add(begin, end, out, options_.gather_samples, [&](size_t i, auto& s) { gather(i, s); });
  }

 private:
  const LightmapSurface& surface(const LightmapTexel& t) const {
    return layout_.surfaces[layout_.charts[t.chart].surface];
  }

  /// What is not sampled.
  void from_solution(size_t begin, size_t end, TexelLight& out) const {
    uint32_t guess = 0xffffffff;
    for (size_t i = begin; i < end; ++i) {
      const LightmapTexel& t = texels_[i];
      const LightmapSurface& s = surface(t);
      const TexelPoint p = texel_point(layout_, t, {t.u, t.v});
      const PatchPlace place = locator_.find(s.instance, p.position, s.back ? -p.facing : p.facing, guess);
      const auto& all = s.back ? solution_.vertex_back_irradiances : solution_.vertex_irradiances;
      const auto& direct = s.back ? solution_.vertex_back_direct_irradiances : solution_.vertex_direct_irradiances;
      Rgb h;
      if (!patch_rays_) h = place.blend(all) - place.blend(direct);
      if (!rays_) h += place.blend(direct);
      out.irradiances[i] = clamped(h, 0, kInfinity);
    }
  }

  template <class Sample>
  void add(size_t begin, size_t end, TexelLight& out, int count, const Sample& sample) const {
    std::vector<Rgb> values;
    for (size_t i = begin; i < end; ++i) {
      values.assign(size_t(count), Rgb(0));
      sample(i, values);
      Samples sums;
      for (const Rgb v : values) sums.add(v);
      out.irradiances[i] += sums.sum / float(count);
      out.variances[i] += sums.variance_of_mean(count);
    }
  }

  SampleSequence sequence(size_t texel, int index) const {
    return {hash_combine(options_.seed, hash32(uint32_t(texel))), uint32_t(index)};
  }
  /// Somewhere in the texel, on its triangle, a little off the edges.
  TexelPoint place(size_t texel, const SampleSequence& sequence) const { return place(texel, sequence.pair(kWithin)); }
  TexelPoint place(size_t texel, Vec2 within) const {
    const LightmapTexel& t = texels_[texel];
    const PlacedChart& chart = layout_.charts[t.chart];
    const FlatTriangle& triangle = chart.texels[t.triangle];
    const Vec2 p = Vec2(float(t.x), float(t.y)) + within;
    Vec2 uv = nearest_on_triangle(triangle, p);
    const Vec2 at = triangle[0] + uv.x * (triangle[1] - triangle[0]) + uv.y * (triangle[2] - triangle[0]);
    const float far = length((triangle[0] + triangle[1] + triangle[2]) / 3.0f - at);
    uv += (Vec2(1.0f / 3) - uv) * std::min(1.0f, kPullIn / std::max(far, 1e-6f));
    return texel_point(layout_, t, uv);
  }

  /// Half of the texel or more lies within a body: from there all rays, four from each quarter, meet backs.
  bool buried(size_t texel) const {
    constexpr Vec2 kCorners[] = {{0.05f, 0.05f}, {0.95f, 0.05f}, {0.05f, 0.95f}, {0.95f, 0.95f}};
    PairPacket random;
    sample_pairs(sequences(~texel, 0, kPacket, kDirection), 0, random);
    RayPacket rays{};
    Vec3 directions[kPacket];
    for (int k = 0; k < kPacket; ++k) {
      const TexelPoint p = place(texel, kCorners[k / 4]);
      directions[k] = Frame(p.facing).to_world(sample_cosine_hemisphere(random.at(k)));
      rays.set(k, {offset_point(p.position, p.facing), directions[k]});
    }
    HitPacket hits;
    rays_->accelerator->intersect(rays, 0xffff, hits, Coherence::incoherent);
    bool within[4] = {true, true, true, true};
    for (int k = 0; k < kPacket; ++k) {
      const Hit hit = hits.at(k);
      within[k / 4] &=
          hit && !rays_->surfaces.material(hit.instance).double_sided && dot(hit.normal, directions[k]) > 0;
    }
    return within[0] + within[1] + within[2] + within[3] >= 2;
  }

  SequencePacket sequences(size_t texel, int first, int count, uint32_t dimension) const {
    SequencePacket packet;
    for (int k = 0; k < count; ++k) packet.set(k, sequence(texel, first + k), dimension);
    return packet;
  }

  void sample_direct(size_t texel, std::vector<Rgb>& values) const {
    thread_local ShadowRays shadows(false);
    PairPacket within, choice, on_lamp;
    for (int first = 0; first < int(values.size()); first += kPacket) {
      const int n = std::min(int(values.size()) - first, int(kPacket));
      const SequencePacket numbers = sequences(texel, first, n, 0);
      sample_pairs(numbers, kWithin, within);
      if (!rays_->lights.only_one()) sample_pairs(numbers, kLampChoice, choice);
      sample_pairs(numbers, kLampPlace, on_lamp);
      for (int k = 0; k < n; ++k) {
        const TexelPoint p = place(texel, within.at(k));
        const Point3 from = offset_point(p.position, p.facing);
        const ArrivingLight light =
            rays_->lights.sample(from, rays_->lights.only_one() ? 0 : choice.at(k).x, on_lamp.at(k));
        const float cosine = dot(light.wi, p.normal);
        if (is_black(light.e_perp) || !(cosine > 0 && dot(light.wi, p.facing) > 0)) continue;
        shadows.add({shadow_ray(from, light.target, light.distant), light.e_perp * cosine, uint32_t(first + k)});
      }
    }
    shadows.trace(*rays_, Coherence::coherent, [&](const ShadowRay& ray) { values[ray.query] += ray.light; });
  }

  void gather(size_t texel, std::vector<Rgb>& values) const {
    PairPacket within, towards;
    for (int first = 0; first < int(values.size()); first += kPacket) {
      const int n = std::min(int(values.size()) - first, int(kPacket));
      const SequencePacket numbers = sequences(~texel, first, n, 0);
      sample_pairs(numbers, kWithin, within), sample_pairs(numbers, kDirection, towards);
      RayPacket packet{};
      Ray rays[kPacket];
      for (int k = 0; k < n; ++k) {
        const TexelPoint p = place(texel, within.at(k));
        const Vec3 direction = Frame(p.normal).to_world(sample_cosine_hemisphere(towards.at(k)));
        rays[k] = {offset_point(p.position, p.facing), normalize(direction)};
        packet.set(k, rays[k]);
      }
      HitPacket hits;
      patch_rays_->accelerator->intersect(packet, (1U << n) - 1, hits, Coherence::incoherent);
      for (int k = 0; k < n; ++k)
        values[size_t(first + k)] = seen(rays[k], hits.at(k), sequence(~texel, first + k)) * float(kPi);
    }
  }

  /// Radiance of what is met, but for light of its own: that is direct light.
  Rgb seen(Ray ray, Hit hit, const SampleSequence& sequence) const {
    for (uint32_t layer = 0; hit && layer < kMostLayers; ++layer) {
      ShadingPoint point;
      patch_rays_->surfaces.shade(ray, hit, false, point);
      if (point.alpha >= 1 || sequence.random(kAlpha + 131 * layer) < point.alpha) {
        if (!point.front && !point.material->double_sided) return Rgb(0);
        return matt_reflectance(*point.surface) * irradiance(point.front, hit) * float(kInvPi);
      }
      ray.origin = offset_point(point.position, -point.geometric);
      hit = patch_rays_->accelerator->intersect(ray);
    }
    return Rgb(0);
  }
  Rgb irradiance(bool front, const Hit& hit) const {
    const auto& v = patches_->vertices[hit.instance][hit.triangle];
    const bool mirrored = glm::determinant(Mat3(patches_->scene.instances[hit.instance].to_world)) < 0;
    const float w[3] = {1 - hit.u - hit.v, mirrored ? hit.v : hit.u, mirrored ? hit.u : hit.v};
    const auto& all = front ? solution_.vertex_irradiances : solution_.vertex_back_irradiances;
    Rgb h;
    for (size_t k = 0; k < 3; ++k) h += all[v[k]].v * w[k];
    return h;
  }

  const Solution& solution_;
  const LightmapLayout& layout_;
  std::span<const LightmapTexel> texels_;
  const LightmapOptions& options_;
  PatchLocator locator_;
  std::optional<RayScene> rays_;         // of the scene: direct light
  std::unique_ptr<PatchScene> patches_;  // what gathering rays see
  std::optional<RayScene> patch_rays_;
};

/// What most texels about it say: single ones err where rays slip through.
void agree_with_most(const LightmapLayout& layout, std::span<const LightmapTexel> texels, std::vector<uint8_t>& flags) {
  if (flags.empty()) return;
  const std::vector<uint8_t> before = flags;
  for (int page = 0; page < int(layout.pages.size()); ++page) {
    const PageIndex index(layout, texels, page);
    for (const uint32_t i : index.all()) {
      int set = 0, all = 0;
      index.around(i, 1, [&](uint32_t k, float) { set += before[k], ++all; });
      flags[i] = 2 * set > all;
    }
  }
}

}  // namespace

TexelPoint texel_point(const LightmapLayout& layout, const LightmapTexel& texel, Vec2 uv) {
  const PlacedChart& chart = layout.charts[texel.chart];
  const LightmapSurface& s = layout.surfaces[chart.surface];
  const uint32_t t = chart.triangles[texel.triangle];
  const float w[3] = {1 - uv.x - uv.y, uv.x, uv.y};
  TexelPoint p{Point3(0), s.facing[t], Vec3(0)};
  for (size_t k = 0; k < 3; ++k) p.position += s.corners[t][k] * w[k], p.normal += s.normals[t][k] * w[k];
  p.normal = normalize_or(p.normal, p.facing);
  return p;
}

TexelLight light_on_texels(const Scene& scene, const Solution& solution, const LightmapLayout& layout,
                           std::span<const LightmapTexel> texels, const LightmapOptions& options, Progress* progress) {
  TexelLight out;
  out.irradiances.resize(texels.size());
  if (options.direct_samples > 0) out.buried.resize(texels.size());
  if (options.direct_samples > 0 || options.gather_samples > 0) out.variances.resize(texels.size());
  if (progress) progress->begin("lightmap", "texels", texels.size());
  const Lighting lighting(scene, solution, layout, texels, options);
  parallel_for(texels.size(), kGrain, [&](size_t begin, size_t end) {
    if (progress && progress->cancelled()) return;
    lighting.run(begin, end, out);
    if (progress) progress->advance(end - begin);
  });
  if (progress) progress->throw_if_cancelled();
  agree_with_most(layout, texels, out.buried);
  return out;
}

}  // namespace aktina
