// Highlight track: normals that can show a highlight lie within a cone, which linear normals cross along a conic on the
// screen. A scanline meets it in a stretch of pixels, between the roots of a quadratic: there the highlight is Phong's,
// elsewhere there is none. Diffuse light is Gouraud's. Cost: a quadratic a lamp and scanline, and the highlight on its
// track only. Weakness: Mach bands of the diffuse part stay. The publication's details could not be read.
//
// Lai, Tai, highlight track shading, 2000.
#include <algorithm>
#include <vector>

#include "aktina/raster/shading/highlight_form.h"
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
    for (const SpanPixels::Run& run : std::span(pixels.runs, size_t(pixels.run_count))) {
      const Vec3 first = normal_at(c, pixels, run.begin) * run.weight[0];
      const Vec3 last = normal_at(c, pixels, run.begin + run.count - 1) * run.weight[1];
      for (const HighlightCone& cone : cones) {
        const HighlightTrack track = highlight_track(cone, first, last, run.count);
        std::fill(on + run.begin + track.begin, on + run.begin + track.end, true);
      }
    }
  }
  static Vec3 normal_at(const CornerValues& c, const SpanPixels& pixels, int i) {
    const float b1 = pixels.b1[i], b2 = pixels.b2[i];
    return c.normal[0] * (1 - b1 - b2) + c.normal[1] * b1 + c.normal[2] * b2;
  }
  bool any_of_block(int begin) const {
    return std::any_of(on + begin, on + begin + kLanes, [](bool flag) { return flag; });
  }
};

/// Evaluates the blocks of pixels that a track touches, and keeps what is on it.
void draw(const OnTrack& track, const CornerValues& c, const SpanPixels& pixels, const Illuminator& light,
          const LitArrays& out) {
  for (int begin = 0; begin < pixels.count;) {
    int end = begin;
    while (end < pixels.count && track.any_of_block(end)) end += int(kLanes);
    if (end > begin) shade_highlights(c, pixels, begin, end, light, out);
    for (int k = 0; k < 3; ++k)
      for (int i = begin; i < end; ++i)
        if (!track.on[i]) out.specular[k][pixels.output + size_t(i)] = 0;
    begin = std::max(end, begin + int(kLanes));
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
