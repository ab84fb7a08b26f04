#include "aktina/radiosity/solver/visibility.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

constexpr int kMostLayers = 64;        // clear surfaces along a ray; what lies beyond is taken as dark
constexpr float kOffset = 4e-6f;       // of the scene's diagonal
constexpr float kRounding = 0x1p-21f;  // of coordinates
constexpr float kLeastShare = 1e-3f;

bool lets_light_through(const Material& m) {
  const bool alpha = m.alpha_mode != AlphaMode::opaque && (m.alpha < 1 || m.base_texture);
  return alpha || !is_black(surface_of(m).kt);
}

template <class T>
T blend(const std::vector<T>& values, const std::array<uint32_t, 3>& t, const Hit& hit, T otherwise) {
  if (values.empty()) return otherwise;
  return values[t[0]] * (1 - hit.u - hit.v) + values[t[1]] * hit.u + values[t[2]] * hit.v;
}

}  // namespace

float ray_offset(const Bounds& scene) {
  float largest = 0;
  for (int k = 0; k < 3; ++k) largest = std::max({largest, std::abs(scene.low[k]), std::abs(scene.high[k])});
  return kOffset * scene.diagonal() + kRounding * largest;
}

Visibility::Visibility(const Scene& scene) : scene_(scene), accelerator_(build_accelerator(scene)) {
  for (const Instance& instance : scene.instances) {
    clear_.push_back(lets_light_through(scene.material_of(instance)));
    any_clear_ = any_clear_ || clear_.back();
  }
  offset_ = ray_offset(bounds(scene));
}

float Visibility::through(const Hit& hit) const {
  if (!clear_[hit.instance]) return 0;
  const Instance& instance = scene_.instances[hit.instance];
  const Mesh& mesh = scene_.meshes[size_t(instance.mesh)];
  const auto& t = mesh.triangles[hit.triangle];
  const Vec2 uv[2] = {blend(mesh.uv[0], t, hit, Vec2(0)), blend(mesh.uv[1], t, hit, Vec2(0))};
  const MaterialPoint m = evaluate(scene_, scene_.material_of(instance), uv, blend(mesh.colours, t, hit, Vec4(1)));
  return std::clamp(luminance(m.surface.kt) * m.alpha + 1 - m.alpha, 0.0f, 1.0f);
}

void Visibility::passing(const RayPacket& rays, uint32_t lanes, Coherence coherence, float* shares) const {
  if (!any_clear_) {
    const uint32_t blocked = accelerator_->occluded(rays, lanes, coherence);
    for (int i = 0; i < kPacket; ++i)
      if (lanes >> i & 1) shares[i] = blocked >> i & 1 ? 0.0f : 1.0f;
    return;
  }
  RayPacket on = rays;
  HitPacket hits;
  for (int i = 0; i < kPacket; ++i)
    if (lanes >> i & 1) shares[i] = 1;
  for (int layer = 0; lanes && layer < kMostLayers; ++layer) {
    accelerator_->intersect(on, lanes, hits, coherence);
    for (int i = 0; i < kPacket; ++i) {
      if (!(lanes >> i & 1)) continue;
      const Hit hit = hits.at(i);
      if (hit) shares[i] *= through(hit);
      if (shares[i] < kLeastShare) shares[i] = 0;
      if (!hit || shares[i] == 0) lanes &= ~(1U << i);
      on.near[i] = hit.distance * (1 + 1e-5f) + offset_ / length(on.at(i).direction);
    }
  }
  for (int i = 0; i < kPacket; ++i)
    if (lanes >> i & 1) shares[i] = 0;
}

void VisibilityQueue::flush() {
  if (count_ == 0) return;
  float shares[kPacket];
  visibility_.passing(rays_, (1U << count_) - 1, coherence_, shares);
  for (int i = 0; i < count_; ++i) sums_[owners_[i]] += weights_[i] * shares[i];
  count_ = 0;
}

}  // namespace aktina
