// A lamp's highlight at the corners of a triangle, for methods that interpolate what makes it.
#pragma once

#include <optional>
#include <vector>

#include "aktina/raster/shading/highlight.h"
#include "aktina/raster/shading/span_pixels.h"

namespace aktina {

struct CornerHighlight {
  Vec3 normal, to_lamp, to_eye, half;  // unit; half between the two before
  float cosine;                        // of the curve
  float facing;                        // n.l; none where it is not positive
  Rgb peak;                            // radiance of the highlight where the cosine is 1, cd/m^2
};

/// @param normal  unit
CornerHighlight corner_highlight(const HighlightCurve& curve, const Illuminator& light, size_t lamp, Point3 position,
                                 Vec3 normal);

/// At the three corners of a triangle.
struct CornerHighlights {
  CornerHighlight corner[3];
  CornerHighlights(const HighlightCurve& curve, const Illuminator& light, size_t lamp, const CornerValues& corners);
  bool dark() const;  // at all corners: behind the surface, or without light

  /// Adds value times the peak, which is linear on the triangle, to specular light, where the light is before the
  /// surface.
  void add(const SpanPixels& pixels, const float* value, const LitArrays& out) const;
};

/// Places of the corners on a plane where the square of the distance from the origin is the highlight's fall(). The
/// normals are turned as their half vectors are turned onto a common one, in a frame about that; z is n.h.
/// C. W. A. M. van Overveld, B. Wyvill 1996, for Blinn's highlight.
struct HighlightPlaces {
  Vec3 corner[3];
  HighlightPlaces(const HighlightCurve& curve, const CornerHighlights& highlights);
};

/// What methods on spans need that add up Gouraud's diffuse light and each lamp's highlight.
ShadingPlan plan_of_highlights();

/// Shades a triangle so. @param set_up  (curve, highlights, lamp's index) -> what a lamp's highlight is interpolated
/// from, or nothing where it cannot be seen; its values(pixels, out) fills the highlight over its peak
template <class SetUp>
void shade_by_lamp(const TriangleGroup& t, int lane, std::span<const Span> spans, const HighlightCurve& curve,
                   const Illuminator& light, const LitArrays& out, const SetUp& set_up) {
  const CornerValues corners(t, lane);
  std::vector<CornerHighlights> highlights;
  std::vector<typename decltype(set_up(corners, highlights[0], size_t()))::value_type> interpolated;
  for (size_t lamp = 0; lamp < light.lamps().size() && curve.power != HighlightCurve::Power::none; ++lamp) {
    const CornerHighlights at_corners(curve, light, lamp, corners);
    if (at_corners.dark()) continue;
    if (auto found = set_up(corners, at_corners, lamp)) {
      highlights.push_back(at_corners);
      interpolated.push_back(*found);
    }
  }
  visit_pixels(t, lane, spans, [&](const SpanPixels& pixels) {
    shade_linear(corners, pixels, false, out);
    alignas(64) float value[SpanPixels::kMost];
    for (size_t i = 0; i < highlights.size(); ++i) {
      interpolated[i].values(pixels, value);
      highlights[i].add(pixels, value, out);
    }
  });
}

}  // namespace aktina
