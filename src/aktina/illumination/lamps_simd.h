// Light that arrives from each kind of lamp, at many points at a time: the formulas of light/. Included by
// illuminator_simd.cpp, once for each instruction set.

#if defined(AKTINA_ILLUMINATION_LAMPS_SIMD_H_) == defined(HWY_TARGET_TOGGLE)  // per-target include guard
#ifdef AKTINA_ILLUMINATION_LAMPS_SIMD_H_
#undef AKTINA_ILLUMINATION_LAMPS_SIMD_H_
#else
#define AKTINA_ILLUMINATION_LAMPS_SIMD_H_
#endif

#include "aktina/illumination/coefficients_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {

/// Unit direction to a lamp and the factor on its colour there.
struct Arrival {
  V3 l;
  F factor;
};

HWY_INLINE F cone_factor(const Lamp& lamp, V3 l) {
  const F c = zero() - dot(l, broadcast(lamp.axis));
  const F ramp = hn::Min(hn::Max(fma(c, set(lamp.ramp_scale), set(lamp.ramp_offset)), zero()), set(1.0f));
  const F factor = hn::IfThenElseZero(c >= set(lamp.outer_cosine), ramp * ramp);
  return lamp.exponent > 0 ? factor * pow(c, set(lamp.exponent)) : factor;
}

/// Two binary searches a point: lane by lane.
HWY_INLINE F table_factor(const Lamp& lamp, V3 l) {
  alignas(64) float x[kPart], y[kPart], z[kPart];
  store(l.x, x), store(l.y, y), store(l.z, z);
  for (size_t i = 0; i < kPart; ++i) x[i] = intensity(*lamp.table, lamp.axis, lamp.c0, -Vec3(x[i], y[i], z[i]));
  return load(x);
}

HWY_INLINE F within(const Lamp& lamp, V3 x, F factor) {
  const V3 low = broadcast(lamp.flap_low), high = broadcast(lamp.flap_high);
  const M above = hn::And(hn::And(x.x >= low.x, x.y >= low.y), x.z >= low.z);
  const M below = hn::And(hn::And(x.x <= high.x, x.y <= high.y), x.z <= high.z);
  return hn::IfThenElseZero(hn::And(above, below), factor);
}

/// theta / sin theta for c = cos theta. With q = tan^2(theta / 2) of the smaller of theta and pi - theta it is
/// (1 + q) times atan(sqrt q) / sqrt q.
HWY_INLINE F angle_over_sine(F c) {
  const F size = hn::Min(hn::Abs(c), set(1.0f)), q = (set(1.0f) - size) / (set(1.0f) + size);
  const F sharp = arc_tangent_ratio(q) * (set(1.0f) + q);
  const F sine = hn::Sqrt(hn::Max(hn::NegMulAdd(c, c, set(1.0f)), set(1e-12f)));
  return select(c < zero(), set(float(kPi)) / sine - sharp, sharp);
}

/// Light of a lamp with an area as a vector (see vector_sample): its direction and length.
HWY_INLINE Arrival arrival_of(V3 irradiance, M lit) {
  const F squared = dot(irradiance, irradiance), inverse = reciprocal_sqrt(hn::Max(squared, set(1e-28f)));
  return {irradiance * inverse, hn::IfThenElseZero(lit, squared * inverse)};
}

HWY_INLINE Arrival arrive_from_rectangle(const Lamp& lamp, V3 x) {
  const V3 u = broadcast(lamp.edge_u), v = broadcast(lamp.edge_v), first = broadcast(lamp.place) - x;
  const F side = zero() - dot(first, broadcast(lamp.axis));
  const V3 corner[4] = {first, first + u, first + u + v, first + v};
  const V3 edge[4] = {u, v, u * set(-1.0f), v * set(-1.0f)};
  F inverse[4];
  for (int k = 0; k < 4; ++k) inverse[k] = inverse_length(dot(corner[k], corner[k]));
  V3 sum{zero(), zero(), zero()};
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    const F scale = inverse[k] * inverse[next];
    // r_{k+1} x r_k = edge x r_k: not from corners, whose difference is small far away
    sum = sum + cross(edge[k], corner[k]) * (scale * angle_over_sine(dot(corner[k], corner[next]) * scale));
  }
  const V3 irradiance = sum * select(side > zero(), set(0.5f), set(-0.5f));
  return arrival_of(irradiance, lamp.both_sides ? side != zero() : side > zero());
}

HWY_INLINE Arrival arrive_from_disc(const Lamp& lamp, V3 x) {
  const V3 axis = broadcast(lamp.axis), from = x - broadcast(lamp.place);
  const F side = dot(from, axis), height = hn::Abs(side);
  const V3 aside = from - axis * side;
  const F h2 = height * height, r2 = set(lamp.radius * lamp.radius), l2 = dot(aside, aside);
  const F beyond = l2 + h2 - r2;
  const F s = hn::Sqrt(hn::Max(fma(beyond, beyond, set(4.0f) * r2 * h2), set(1e-28f)));
  const F far = set(2.0f) * r2 * h2 / (s * (s + hn::Max(beyond, zero())));
  const F facing = select(beyond > zero(), far, set(0.5f) - set(0.5f) * beyond / s);
  const F across = set(2.0f) * height * r2 / (s * (s + l2 + h2 + r2));
  const F towards = select(side > zero(), zero() - facing, facing);
  const V3 factor = axis * towards - aside * across;
  return arrival_of(factor * set(float(kPi)), lamp.both_sides ? side != zero() : side > zero());
}

HWY_INLINE Arrival arrive(const Lamp& lamp, V3 x) {
  if (lamp.shape == LampShape::rectangle) return arrive_from_rectangle(lamp, x);
  if (lamp.shape == LampShape::disc) return arrive_from_disc(lamp, x);
  if (lamp.distant) return {broadcast(lamp.place), set(1.0f)};
  const V3 d = broadcast(lamp.place) - x;
  const F squared = hn::Max(dot(d, d), set(1e-30f));
  const F inverse = reciprocal_sqrt(squared);
  Arrival a{d * inverse, inverse * inverse};
  if (!lamp.inverse_square) {
    const Attenuation& f = lamp.attenuation;
    const F distance = squared * inverse;
    const F sum = fma(distance, fma(distance, set(f.a2), set(f.a1)), set(f.a0));
    a.factor = reciprocal(hn::Max(sum, set(1e-30f)));
    if (f.clamp) a.factor = hn::Min(a.factor, set(1.0f));
  }
  if (lamp.table) a.factor = a.factor * table_factor(lamp, a.l);
  if (lamp.flaps) a.factor = within(lamp, x, a.factor);
  if (lamp.cone) a.factor = a.factor * cone_factor(lamp, a.l);
  return a;
}

}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
