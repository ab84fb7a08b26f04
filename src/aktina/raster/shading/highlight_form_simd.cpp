// Highlights of one lamp at the pixels of a triangle, in closed form.
#include <algorithm>

#include "aktina/raster/shading/highlight_form.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/shading/highlight_form_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/raster/shading/highlight_power_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

/// A value that is linear on the triangle.
struct Linear {
  float at0, along1, along2;
  Linear(float v0, float v1, float v2) : at0(v0), along1(v1 - v0), along2(v2 - v0) {}
  HWY_INLINE F operator()(F b1, F b2) const { return fma(b1, set(along1), fma(b2, set(along2), set(at0))); }
};

template <bool Schlick, class Form>
HWY_INLINE void add(const HighlightCurve& curve, const CornerHighlights& h, const Form& value, const SpanPixels& pixels,
                    const LitArrays& out) {
  const auto& [h0, h1, h2] = h.corner;
  const Linear facing(h0.facing, h1.facing, h2.facing);
  const bool faces = std::min({h0.facing, h1.facing, h2.facing}) > 0;
  const Linear peak[] = {
      {h0.peak.r, h1.peak.r, h2.peak.r}, {h0.peak.g, h1.peak.g, h2.peak.g}, {h0.peak.b, h1.peak.b, h2.peak.b}};
  for (size_t i = 0; i < size_t(pixels.count); i += kPart) {
    const F b1 = load(pixels.b1 + i), b2 = load(pixels.b2 + i);
    F factor = value.template at<Schlick>(curve, b1, b2);
    if (!faces) factor = hn::IfThenElseZero(facing(b1, b2) > zero(), factor);
    for (int k = 0; k < 3; ++k) {
      float* const to = out.specular[k] + pixels.output + i;
      store(fma(factor, peak[k](b1, b2), load(to)), to);
    }
  }
}

template <class Form>
HWY_INLINE void add_any(const HighlightCurve& curve, const CornerHighlights& h, const Form& value,
                        const SpanPixels& pixels, const LitArrays& out) {
  if (curve.power == HighlightCurve::Power::schlick) return add<true>(curve, h, value, pixels, out);
  add<false>(curve, h, value, pixels, out);
}

struct Place {
  Linear x, y, z;
  template <bool Schlick>
  HWY_INLINE F at(const HighlightCurve& curve, F b1, F b2) const {
    const F u = x(b1, b2), v = y(b1, b2);
    return hn::IfThenElseZero(z(b1, b2) > zero(), highlight_of<Schlick>(curve, fma(u, u, v * v)));
  }
};

struct Quadratic {
  const float* c;
  template <bool Schlick>
  HWY_INLINE F at(const HighlightCurve& curve, F b1, F b2) const {
    const F linear = fma(b1, set(c[1]), fma(b2, set(c[2]), set(c[0])));
    const F inner = fma(b1, set(c[3]), b2 * set(c[4]));
    return highlight_of<Schlick>(curve, fma(b1, inner, fma(b2 * b2, set(c[5]), linear)));
  }
};

struct Map {
  const float* texels;
  int size;
  Linear x, y;
  template <bool Schlick>
  HWY_INLINE F at(const HighlightCurve&, F b1, F b2) const {
    const F last = set(float(size - 1) - 1e-3f);
    const F u = hn::Min(hn::Max(x(b1, b2), zero()), last), v = hn::Min(hn::Max(y(b1, b2), zero()), last);
    const I column = hn::ConvertTo(kInt, u), row = hn::ConvertTo(kInt, v);
    const F s = u - to_float(column), t = v - to_float(row);
    const I at = row * set(int32_t(size)) + column;
    const auto texel = [&](int32_t offset) HWY_ATTR { return hn::GatherIndex(kFloat, texels, at + set(offset)); };
    const F top0 = texel(0), low0 = texel(int32_t(size));
    const F top = fma(s, texel(1) - top0, top0), low = fma(s, texel(int32_t(size) + 1) - low0, low0);
    return fma(t, low - top, top);
  }
};

void AddPlace(const HighlightCurve& curve, const CornerHighlights& h, const PlaceForm& form, const SpanPixels& pixels,
              const LitArrays& out) {
  const auto& [a, b, c] = form.corner;
  add_any(curve, h, Place{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}}, pixels, out);
}
void AddQuadratic(const HighlightCurve& curve, const CornerHighlights& h, const QuadraticForm& form,
                  const SpanPixels& pixels, const LitArrays& out) {
  add_any(curve, h, Quadratic{form.coefficient}, pixels, out);
}
void AddMap(const HighlightCurve& curve, const CornerHighlights& h, const MapForm& form, const SpanPixels& pixels,
            const LitArrays& out) {
  const auto& [a, b, c] = form.corner;
  add<false>(curve, h, Map{form.texels, form.size, {a.x, b.x, c.x}, {a.y, b.y, c.y}}, pixels, out);
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(AddPlace);
HWY_EXPORT(AddQuadratic);
HWY_EXPORT(AddMap);

void add_highlight(const HighlightCurve& curve, const CornerHighlights& h, const PlaceForm& form,
                   const SpanPixels& pixels, const LitArrays& out) {
  HWY_DYNAMIC_DISPATCH(AddPlace)(curve, h, form, pixels, out);
}
void add_highlight(const HighlightCurve& curve, const CornerHighlights& h, const QuadraticForm& form,
                   const SpanPixels& pixels, const LitArrays& out) {
  HWY_DYNAMIC_DISPATCH(AddQuadratic)(curve, h, form, pixels, out);
}
void add_highlight(const HighlightCurve& curve, const CornerHighlights& h, const MapForm& form,
                   const SpanPixels& pixels, const LitArrays& out) {
  HWY_DYNAMIC_DISPATCH(AddMap)(curve, h, form, pixels, out);
}

}  // namespace aktina
#endif
