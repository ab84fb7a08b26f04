// Highlights of near lamps by the table of an infinitely far one: the normal at each corner is turned as its half
// vector is turned onto a common one, so that the pattern stays the same; then only the two coordinates across that
// common direction are interpolated, and the highlight is a function of their squares. A planar polygon can carry a
// highlight so. Phong's highlight is an ellipse on the same plane, where Blinn's is a circle. Diffuse light is
// Gouraud's. Cost: three additions (the third coordinate tells front from back) and a power a lamp and pixel, in place
// of the publication's table. Weakness: interpolated coordinates are no unit vectors; the light of a near lamp is
// linear over a triangle; the common direction is each triangle's own, so that neighbours differ a little at an edge.
//
// C. W. A. M. van Overveld, B. Wyvill, "Hi-speed, hi-fi, hi-lights", 1996.
#include <optional>

#include "aktina/raster/shading/highlight_form.h"

namespace aktina {
namespace {

class OverveldHighlights final : public ShadingMethod {
 public:
  ShadingPlan plan(const Illuminator& light) const override {
    sole_highlight_curve(light, "overveld_highlights");
    return plan_of_highlights();
  }

  void shade_spans(const TriangleGroup& t, int lane, std::span<const Span> spans, const Illuminator& light,
                   const LitArrays& out) const override {
    const HighlightCurve curve = sole_highlight_curve(light, "overveld_highlights");
    shade_by_lamp(t, lane, spans, curve, light, out, [&](const CornerValues&, const CornerHighlights& h, size_t) {
      const HighlightPlaces places(curve, h);
      return std::optional(PlaceForm{{places.corner[0], places.corner[1], places.corner[2]}});
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
