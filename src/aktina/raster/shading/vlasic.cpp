// A specularity map: the corners' normals, in the frame of their half vectors, are places on a map of the highlight,
// and texture mapping does the rest. The map is square, its texels (1 - u^2 - v^2)^(n/2), read between four of them.
// Phong's highlight has its map too, on which it is a circle as Blinn's is. Diffuse light is Gouraud's. Cost: one
// reading of the map a lamp and pixel; a map for each exponent. Weakness: sharp highlights are smaller than its texels;
// coordinates that are interpolated on a plane make the highlight wrong by the square of the angle spanned; each
// triangle has a frame of its own, so that neighbours differ a little at an edge.
//
// D. Vlasic, "Fake Phong Shading", Massachusetts Institute of Technology, 2002.
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <tuple>

#include "aktina/base/error.h"
#include "aktina/raster/shading/highlight_form.h"

namespace aktina {
namespace {

class SpecularityMap {
 public:
  static constexpr size_t kSize = 256;

  explicit SpecularityMap(const HighlightCurve& curve) : lines_(kSize * kSize / kLanes) {
    float* const texels = lines_[0].v;
    for (size_t y = 0; y < kSize; ++y)
      for (size_t x = 0; x < kSize; ++x) {
        const float u = coordinate(x), v = coordinate(y);
        texels[y * kSize + x] = u * u + v * v;
      }
    highlight_values(curve, texels, kSize * kSize);
  }

  MapForm form(const HighlightPlaces& places) const {
    MapForm form{lines_[0].v, int(kSize), {}};
    for (int v = 0; v < 3; ++v) form.corner[v] = kScale * on_map(places.corner[v]) + Vec2(kMiddle);
    return form;
  }

 private:
  static constexpr float kMiddle = 0.5f * float(kSize), kScale = kMiddle - 1;  // a texel has the peak
  static Vec2 on_map(Vec3 place) {
    const Vec2 p(place.x, place.y);
    if (place.z >= 0) return p;
    const float r = std::sqrt(p.x * p.x + p.y * p.y);  // behind: beyond the disc
    return r > 0 ? p * (std::max(2 - r, 1.0f) / r) : Vec2(2, 0);
  }
  static float coordinate(size_t i) { return (float(i) - kMiddle) / kScale; }
  std::vector<Lanes> lines_;
};

/// Maps for the highlights of a scene's materials, made as they are met.
class SpecularityMaps {
 public:
  static constexpr size_t kMost = 1024;  // 256 KiB each

  const SpecularityMap& of(const HighlightCurve& curve) {
    const std::tuple key(curve.power, curve.half, curve.exponent);
    {
      const std::shared_lock lock(mutex_);
      const auto known = maps_.find(key);
      if (known != maps_.end()) return known->second;
    }
    const std::unique_lock lock(mutex_);
    if (maps_.size() == kMost && !maps_.contains(key))
      throw Error(Code::limit, "shading.vlasic", "got more than 1024 different exponents", "a method without maps");
    return maps_.try_emplace(key, curve).first->second;
  }

 private:
  std::shared_mutex mutex_;
  std::map<std::tuple<HighlightCurve::Power, bool, float>, SpecularityMap> maps_;
};

class VlasicShading final : public ShadingMethod {
 public:
  ShadingPlan plan(const Illuminator& light) const override {
    const HighlightCurve curve = sole_highlight_curve(light, "vlasic");
    if (curve.power != HighlightCurve::Power::none) maps_.of(curve);
    return plan_of_highlights();
  }

  void shade_spans(const TriangleGroup& t, int lane, std::span<const Span> spans, const Illuminator& light,
                   const LitArrays& out) const override {
    const HighlightCurve curve = sole_highlight_curve(light, "vlasic");
    const SpecularityMap* const map = curve.power == HighlightCurve::Power::none ? nullptr : &maps_.of(curve);
    shade_by_lamp(t, lane, spans, curve, light, out, [&](const CornerValues&, const CornerHighlights& h, size_t) {
      return std::optional(map->form(HighlightPlaces(curve, h)));
    });
  }

 private:
  mutable SpecularityMaps maps_;
};

}  // namespace

extern constinit const ShadingRow vlasic_shading = {
    {"vlasic", "Vlasic's specularity map", "vlasic2002",
     "Corners are places on a map of the highlight, which texture mapping reads; Gouraud's diffuse light."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<VlasicShading>(); }};

}  // namespace aktina
