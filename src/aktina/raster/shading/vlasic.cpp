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
#include <shared_mutex>
#include <tuple>

#include "aktina/base/error.h"
#include "aktina/raster/shading/corner_highlight.h"

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

  /// @param u, v  a place: dark beyond the unit disc
  float operator()(float u, float v) const {
    constexpr float kLast = float(kSize - 1) - 1e-3f;
    const float x = std::min(std::max(0.0f, u * kScale + kMiddle), kLast);
    const float y = std::min(std::max(0.0f, v * kScale + kMiddle), kLast);
    const auto left = size_t(x), top = size_t(y);
    const float s = x - float(left), t = y - float(top);
    const float* const texel = lines_[0].v + top * kSize + left;
    return (1 - t) * ((1 - s) * texel[0] + s * texel[1]) + t * ((1 - s) * texel[kSize] + s * texel[kSize + 1]);
  }

 private:
  static constexpr float kMiddle = kSize / 2, kScale = kMiddle - 1;  // a texel has the peak
  static float coordinate(size_t i) { return (float(i) - kMiddle) / kScale; }
  std::vector<Lanes> lines_;
};

/// One lamp's.
struct MappedHighlight {
  const SpecularityMap* map;
  Vec2 place[3];

  MappedHighlight(const SpecularityMap& on, const HighlightPlaces& places) : map(&on) {
    for (int v = 0; v < 3; ++v) {
      const Vec3 d = places.corner[v];
      place[v] = {d.x, d.y};
      if (d.z >= 0) continue;  // behind: beyond the disc
      const float r = std::sqrt(d.x * d.x + d.y * d.y);
      place[v] = r > 0 ? place[v] * (std::max(2 - r, 1.0f) / r) : Vec2(2, 0);
    }
  }

  void values(const SpanPixels& pixels, float* out) const {
    alignas(64) float v[SpanPixels::kMost];
    pixels.linear(place[0].x, place[1].x, place[2].x, out);
    pixels.linear(place[0].y, place[1].y, place[2].y, v);
    for (size_t i = 0; i < padded(size_t(pixels.count)); ++i) out[i] = (*map)(out[i], v[i]);
  }
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
    shade_by_lamp(t, lane, spans, curve, light, out,
                  [&](const CornerValues&, const CornerHighlights& h, size_t) -> std::optional<MappedHighlight> {
                    return MappedHighlight(maps_.of(curve), HighlightPlaces(curve, h));
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
