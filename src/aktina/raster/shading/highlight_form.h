// What a lamp's highlight is made of at a pixel, in the barycentric coordinates b1, b2 of corners 1 and 2.
#pragma once

#include <vector>

#include "aktina/raster/shading/corner_highlight.h"

namespace aktina {

/// Two coordinates that are linear on the triangle: fall() is the sum of their squares, where a third one is positive.
struct PlaceForm {
  Vec3 corner[3];
};

/// fall() as a polynomial: of 1, b1, b2, b1^2, b1 b2, b2^2.
struct QuadraticForm {
  float coefficient[6];
};

/// A map of highlights, read between four texels at two coordinates that are linear on the triangle, in texels.
struct MapForm {
  const float* texels;
  int size;  // of the square map
  Vec2 corner[3];
};

/// Adds a lamp's highlight to specular light, where the lamp is before the surface.
void add_highlight(const HighlightCurve& curve, const CornerHighlights& h, const PlaceForm& form,
                   const SpanPixels& pixels, const LitArrays& out);
void add_highlight(const HighlightCurve& curve, const CornerHighlights& h, const QuadraticForm& form,
                   const SpanPixels& pixels, const LitArrays& out);
void add_highlight(const HighlightCurve& curve, const CornerHighlights& h, const MapForm& form,
                   const SpanPixels& pixels, const LitArrays& out);

/// The published recurrences of fall() along a scanline in a parallel projection, `count` pixels from (b1, b2) on by
/// (step1, step2): two additions each. x += dx, y += dy; and u += du, du += ddu.
std::vector<float> fall_recurrence(const PlaceForm& form, float b1, float b2, float step1, float step2, int count);
std::vector<float> fall_recurrence(const QuadraticForm& form, float b1, float b2, float step1, float step2, int count);

/// What methods on spans need that add up Gouraud's diffuse light and each lamp's highlight.
ShadingPlan plan_of_highlights();

/// Shades a triangle so. @param form_of  (corners, highlights, lamp's index) -> optional form; none: it cannot be seen
template <class FormOf>
void shade_by_lamp(const TriangleGroup& t, int lane, std::span<const Span> spans, const HighlightCurve& curve,
                   const Illuminator& light, const LitArrays& out, const FormOf& form_of) {
  const CornerValues corners(t, lane);
  using Form = typename decltype(form_of(corners, std::declval<CornerHighlights>(), size_t()))::value_type;
  struct LampForm {
    CornerHighlights highlights;
    Form form;
  };
  std::vector<LampForm> lamps;
  for (size_t lamp = 0; lamp < light.lamps().size() && curve.power != HighlightCurve::Power::none; ++lamp) {
    const CornerHighlights highlights(curve, light, lamp, corners);
    if (highlights.dark()) continue;
    if (const auto form = form_of(corners, highlights, lamp)) lamps.push_back({highlights, *form});
  }
  visit_pixels(t, lane, spans, [&](const SpanPixels& pixels) {
    shade_linear(corners, pixels, false, out);
    for (const LampForm& lamp : lamps) add_highlight(curve, lamp.highlights, lamp.form, pixels, out);
  });
}

}  // namespace aktina
