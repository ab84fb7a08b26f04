// Highlight track: normals that can show a highlight lie within a cone, which linear normals cross along a conic on the
// screen. A scanline meets it in a stretch of pixels, between the roots of a quadratic: there the highlight is Phong's,
// elsewhere there is none. Diffuse light is Gouraud's. Cost: a quadratic a lamp and scanline, and the highlight on its
// track only. Weakness: Mach bands of the diffuse part stay. The publication's details could not be read.
//
// Lai, Tai, highlight track shading, 2000.
#include <algorithm>
#include <vector>

#include "aktina/raster/shading/corner_highlight.h"
#include "aktina/raster/shading/highlight_track.h"
#include "aktina/raster/shading/span_pixels.h"

namespace aktina {
namespace {

std::vector<HighlightCone> cones_of(const CornerValues& c, const Illuminator& light, float share) {
  const HighlightCurve curve = highlight_curve(light, "lai_tai");
  const float least = curve.cosine_at(share);
  std::vector<HighlightCone> cones;
  for (const Lamp& lamp : light.lamps())
    if (may_shine(curve, least, lamp, light.viewer(), c.position, c.normal))
      cones.push_back(highlight_cone(curve, least, lamp, light.viewer(), c.position));
  return cones;
}

/// A flag for each pixel: on some lamp's track.
struct OnTrack {
  bool on[SpanPixels::kMost] = {};

  OnTrack(std::span<const HighlightCone> cones, const CornerValues& c, const SpanPixels& pixels) {
    const auto last = size_t(pixels.count - 1);
    const auto normal = [&](size_t i) {
      return c.normal[0] * (1 - pixels.b1[i] - pixels.b2[i]) + c.normal[1] * pixels.b1[i] + c.normal[2] * pixels.b2[i];
    };
    const Vec3 ends[] = {normal(0) * pixels.weight[0], normal(last) * pixels.weight[1]};
    for (const HighlightCone& cone : cones) {
      const HighlightTrack track = highlight_track(cone, ends[0], ends[1], pixels.count);
      for (int i = track.begin; i < track.end; ++i) on[i] = true;
    }
  }
  bool any(int begin, int end) const {
    return std::any_of(on + begin, on + end, [](bool flag) { return flag; });
  }
};

void draw(const OnTrack& track, const CornerValues& c, const SpanPixels& pixels, const Illuminator& light,
          const LitArrays& out) {
  constexpr int kBlock = int(kLanes);
  for (int begin = 0; begin < pixels.count;) {
    int end = begin;
    while (end < pixels.count && track.any(end, std::min(end + kBlock, pixels.count))) end += kBlock;
    end = std::min(end, pixels.count);
    if (end > begin) shade_highlights(c, pixels, begin, end - begin, light, out);
    for (int k = 0; k < 3; ++k)
      for (int i = begin; i < end; ++i)
        if (!track.on[i]) out.specular[k][pixels.output + size_t(i)] = 0;
    begin = end == begin ? begin + kBlock : end;
  }
}

class LaiTaiShading final : public ShadingMethod {
 public:
  explicit LaiTaiShading(float share) : share_(share) {}

  ShadingPlan plan(const Illuminator& light) const override {
    highlight_curve(light, "lai_tai");
    return plan_of_highlights();
  }

  void shade_spans(const TriangleGroup& t, int lane, std::span<const Span> spans, const Illuminator& light,
                   const LitArrays& out) const override {
    const CornerValues corners(t, lane);
    const std::vector<HighlightCone> cones = cones_of(corners, light, share_);
    visit_pixels(t, lane, spans, [&](const SpanPixels& pixels) {
      shade_linear(corners, pixels, false, out);
      if (!cones.empty()) draw(OnTrack(cones, corners, pixels), corners, pixels, light, out);
    });
  }

 private:
  float share_;
};

constexpr Param kParams[] = {
    {"share", "1", "the track is where the highlight exceeds this share of its peak", 1.0 / 512, 0, 1}};

}  // namespace

extern constinit const ShadingRow lai_tai_shading = {
    {"lai_tai", "Lai and Tai's highlight track", "lai2000",
     "Finds the stretch of each scanline that can show a highlight, and evaluates it there; Gouraud's diffuse light.",
     kParams},
    [](const ParamSet& p) -> std::unique_ptr<ShadingMethod> {
      return std::make_unique<LaiTaiShading>(float(p["share"]));
    }};

}  // namespace aktina
