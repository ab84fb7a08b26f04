// Highlights of near lamps by the table of an infinitely far one: the normal at each corner is turned as its half
// vector is turned onto a common one, so that the pattern stays the same; then only the two coordinates across that
// common direction are interpolated, and the highlight is a function of their squares. A planar polygon can carry a
// highlight so. Phong's highlight is an ellipse on the same plane, where Blinn's is a circle. Diffuse light is
// Gouraud's. Cost: three additions (the third coordinate tells front from back) and a power a lamp and pixel, in place
// of the publication's table. Weakness: interpolated coordinates are no unit vectors; the light of a near lamp is
// linear over a triangle; the common direction is each triangle's own, so that neighbours differ a little at an edge.
//
// C. W. A. M. van Overveld, B. Wyvill, "Hi-speed, hi-fi, hi-lights", 1996.
#include "aktina/raster/shading/corner_highlight.h"

namespace aktina {
namespace {

/// One lamp's.
struct TurnedHighlight {
  HighlightCurve curve;
  HighlightPlaces places;

  void values(const SpanPixels& pixels, float* out) const {
    alignas(64) float y[SpanPixels::kMost], z[SpanPixels::kMost];
    const auto& [v0, v1, v2] = places.corner;
    pixels.linear(v0.x, v1.x, v2.x, out);
    pixels.linear(v0.y, v1.y, v2.y, y);
    pixels.linear(v0.z, v1.z, v2.z, z);
    for (size_t i = 0; i < padded(size_t(pixels.count)); ++i) out[i] = z[i] > 0 ? out[i] * out[i] + y[i] * y[i] : 1;
    highlight_values(curve, out, size_t(pixels.count));
  }
};

class OverveldHighlights final : public ShadingMethod {
 public:
  ShadingPlan plan(const Illuminator& light) const override {
    sole_highlight_curve(light, "overveld_highlights");
    return plan_of_highlights();
  }

  void shade_spans(const TriangleGroup& t, int lane, std::span<const Span> spans, const Illuminator& light,
                   const LitArrays& out) const override {
    const HighlightCurve curve = sole_highlight_curve(light, "overveld_highlights");
    shade_by_lamp(t, lane, spans, curve, light, out,
                  [&](const CornerValues&, const CornerHighlights& h, size_t) -> std::optional<TurnedHighlight> {
                    return TurnedHighlight{curve, HighlightPlaces(curve, h)};
                  });
  }
};

}  // namespace

extern constinit const ShadingRow overveld_highlights_shading = {
    {"overveld_highlights", "van Overveld and Wyvill's highlights of infinite lights", "overveld1996",
     "Normals turned so that near lamps light as far ones; two coordinates give the highlight; Gouraud's diffuse "
     "light."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<OverveldHighlights>(); }};

}  // namespace aktina
