// may_shine() for a group of triangles, and highlights from how far their peak is, many at a time.
#include "aktina/raster/shading/highlight.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/shading/highlight_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/raster/shading/highlight_power_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

constexpr float kRounding = 2e-6f;  // reciprocal square roots have 21 bits

struct V3 {
  F x, y, z;
};
HWY_INLINE V3 broadcast(Vec3 v) { return {set(v.x), set(v.y), set(v.z)}; }
HWY_INLINE V3 operator+(V3 a, V3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HWY_INLINE V3 operator-(V3 a, V3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE V3 operator*(V3 a, F s) { return {a.x * s, a.y * s, a.z * s}; }
HWY_INLINE F dot(V3 a, V3 b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }
HWY_INLINE V3 cross(V3 a, V3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
HWY_INLINE F inverse_length(V3 v) { return reciprocal_sqrt(hn::Max(dot(v, v), set(1e-30f))); }

/// kPart triangles in registers.
struct Triangles {
  V3 position[3], normal[3];
  Triangles(const TriangleGroup& t, size_t i) {
    for (int k = 0; k < 3; ++k) {
      position[k] = {load(t.position[k][0].v + i), load(t.position[k][1].v + i), load(t.position[k][2].v + i)};
      normal[k] = {load(t.normal[k][0].v + i), load(t.normal[k][1].v + i), load(t.normal[k][2].v + i)};
    }
  }
};

struct Cap {
  V3 axis;
  F chord;
};

HWY_INLINE Cap cap_towards(Vec3 at, bool distant, const Triangles& t) {
  if (distant) return {broadcast(at), zero()};
  V3 d[3];
  for (int k = 0; k < 3; ++k) {
    const V3 to = broadcast(at) - t.position[k];
    d[k] = to * inverse_length(to);
  }
  const V3 sum = d[0] + d[1] + d[2];
  Cap cap{sum * inverse_length(sum), zero()};
  for (const V3& one : d) {
    const V3 off = one - cap.axis;
    cap.chord = hn::Max(cap.chord, dot(off, off));
  }
  cap.chord = hn::Sqrt(cap.chord);
  return cap;
}

HWY_INLINE F edge_peak(V3 n0, V3 n1, F a, F b) {
  const F c = dot(n0, n1), up = b - a * c, down = a - b * c, ends = hn::Max(a, b);
  const F sum = up + down, t = up / hn::Max(sum, set(1e-30f));
  const F squared = set(1.0f) - (t + t) * (set(1.0f) - t) * (set(1.0f) - c);
  const F inner = fma(t, b - a, a) * reciprocal_sqrt(hn::Max(squared, set(1e-12f)));
  return select(hn::And(up > zero(), down > zero()), inner, ends);
}

HWY_INLINE F highlight_peak(const Triangles& t, V3 h) {
  F along[3];
  for (int k = 0; k < 3; ++k) along[k] = dot(t.normal[k], h);
  F peak = edge_peak(t.normal[0], t.normal[1], along[0], along[1]);
  peak = hn::Max(peak, edge_peak(t.normal[1], t.normal[2], along[1], along[2]));
  peak = hn::Max(peak, edge_peak(t.normal[2], t.normal[0], along[2], along[0]));
  V3 across[3];
  for (int k = 0; k < 3; ++k) across[k] = cross(t.normal[(k + 1) % 3], t.normal[(k + 2) % 3]);
  const F determinant = dot(t.normal[0], across[0]);
  M within = hn::Abs(determinant) > set(1e-7f);
  for (const V3& a : across) within = hn::And(within, dot(h, a) * determinant >= zero());
  return select(within, set(1.0f), peak);
}

HWY_INLINE M faces(const Triangles& t, const Lamp& lamp) {
  F most = set(-1.0f);
  for (const V3& p : t.position) {
    const V3 l = lamp.distant ? broadcast(lamp.place) : broadcast(lamp.place) - p;
    for (const V3& n : t.normal) most = hn::Max(most, dot(n, l));
  }
  return most > zero();
}

/// highlight_cone(), lane by lane.
HWY_INLINE M shines(const HighlightCurve& curve, float least, const Lamp& lamp, const Cap& to_eye, const Triangles& t) {
  const Cap to_lamp = cap_towards(lamp.place, lamp.distant, t);
  const V3 sum = to_lamp.axis + to_eye.axis;
  const F slack = to_lamp.chord + to_eye.chord + set(kRounding), squared = dot(sum, sum), size = hn::Sqrt(squared);
  const F half_cosine = (size - slack) * set(0.5f);
  M all = hn::Or(hn::Not(half_cosine > set(5e-4f)), hn::Max(to_lamp.chord, to_eye.chord) > set(1.3f));
  const F squared_sine =
      curve.half ? set(1 - least * least) : set((1 - least) / 2) / hn::Max(half_cosine * half_cosine, set(1e-30f));
  all = hn::Or(all, squared_sine >= set(1.0f));
  const F one = set(1.0f), cosine = hn::Sqrt(hn::Max(one - squared_sine, zero()));
  const F spread = hn::Min(slack / hn::Max(size, set(1e-30f)), one);
  const F limit = cosine * hn::Sqrt(hn::Max(hn::NegMulAdd(spread, spread, one), zero())) -
                  hn::Sqrt(squared_sine) * spread - set(kRounding);
  const F peak = highlight_peak(t, sum * reciprocal_sqrt(hn::Max(squared, set(1e-30f))));
  return hn::And(faces(t, lamp), hn::Or(all, hn::Not(peak < limit)));
}

uint32_t MayShine(const HighlightCurve& curve, float least, const Illuminator& light, const TriangleGroup& group) {
  uint32_t bits = 0;
  for (size_t i = 0; i < kLanes; i += kPart) {
    const Triangles t(group, i);
    const Cap to_eye = cap_towards(light.viewer().at, light.viewer().distant, t);
    uint32_t part = 0;
    for (const Lamp& lamp : light.lamps())
      part |= lamp.shape == LampShape::point ? bits_of(shines(curve, least, lamp, to_eye, t)) : (1U << kPart) - 1;
    bits |= part << i;
  }
  return bits;
}

void HighlightValues(const HighlightCurve& curve, float* values, size_t count) {
  const bool schlick = curve.power == HighlightCurve::Power::schlick;
  for (size_t i = 0; i < padded(count); i += kPart) {
    const F fall = load(values + i);
    store(schlick ? highlight_of<true>(curve, fall) : highlight_of<false>(curve, fall), values + i);
  }
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(MayShine);
HWY_EXPORT(HighlightValues);

uint32_t may_shine(const HighlightCurve& curve, float least, const Illuminator& light, const TriangleGroup& triangles) {
  return least > 1 ? 0 : HWY_DYNAMIC_DISPATCH(MayShine)(curve, least, light, triangles);
}

void highlight_values(const HighlightCurve& curve, float* values, size_t count) {
  HWY_DYNAMIC_DISPATCH(HighlightValues)(curve, values, count);
}

}  // namespace aktina
#endif
