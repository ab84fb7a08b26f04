// What the SIMD code of all rooms shares: vectors of at most sixteen floats, and the functions Highway has not.
// Included by *_simd.cpp files after <hwy/foreach_target.h>, once for each instruction set.
//
// Relative errors are stated for normal results; denormals are flushed to zero (base/parallel.h).

#if defined(AKTINA_BASE_SIMD_H_) == defined(HWY_TARGET_TOGGLE)  // per-target include guard
#ifdef AKTINA_BASE_SIMD_H_
#undef AKTINA_BASE_SIMD_H_
#else
#define AKTINA_BASE_SIMD_H_
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, 16>;
using IntTag = hn::Rebind<int32_t, FloatTag>;
using F = hn::Vec<FloatTag>;
using I = hn::Vec<IntTag>;
using M = hn::Mask<FloatTag>;
inline constexpr FloatTag kFloat;
inline constexpr IntTag kInt;
/// Lanes of F: 4, 8 or 16. A block of sixteen values is kParts of them.
inline constexpr size_t kPart = hn::MaxLanes(FloatTag());
inline constexpr size_t kParts = 16 / kPart;

HWY_INLINE F set(float x) { return hn::Set(kFloat, x); }
HWY_INLINE I set(int32_t x) { return hn::Set(kInt, x); }
HWY_INLINE F zero() { return hn::Zero(kFloat); }
HWY_INLINE F load(const float* p) { return hn::Load(kFloat, p); }
HWY_INLINE void store(F x, float* p) { hn::Store(x, kFloat, p); }
HWY_INLINE I load(const int32_t* p) { return hn::Load(kInt, p); }
HWY_INLINE void store(I x, int32_t* p) { hn::Store(x, kInt, p); }
HWY_INLINE F to_float(I x) { return hn::ConvertTo(kFloat, x); }
HWY_INLINE F bits_of(I x) { return hn::BitCast(kFloat, x); }
HWY_INLINE I bits_of(F x) { return hn::BitCast(kInt, x); }
HWY_INLINE F fma(F a, F b, F c) { return hn::MulAdd(a, b, c); }
HWY_INLINE M mask(hn::Mask<IntTag> m) { return hn::RebindMask(kFloat, m); }
HWY_INLINE hn::Mask<IntTag> int_mask(M m) { return hn::RebindMask(kInt, m); }
HWY_INLINE F select(M m, F yes, F no) { return hn::IfThenElse(m, yes, no); }
HWY_INLINE I select(M m, I yes, I no) { return hn::IfThenElse(int_mask(m), yes, no); }

/// Bit i: lane i of the mask.
HWY_INLINE uint32_t bits_of(M m) {
  uint8_t bytes[8] = {};
  hn::StoreMaskBits(kFloat, m, bytes);
  return (bytes[0] | uint32_t(bytes[1]) << 8) & ((1U << kPart) - 1);
}
/// Lanes first .. first + kPart - 1 of sixteen bits.
HWY_INLINE M mask_of(uint32_t bits, size_t first) {
  const uint32_t part = bits >> first;
  const uint8_t bytes[8] = {uint8_t(part), uint8_t(part >> 8)};
  return hn::LoadMaskBits(kFloat, bytes);
}

/// 1 / x, relative error 2^-21. @pre  2^-100 < |x| < 2^100
HWY_INLINE F reciprocal(F x) {
  const F r = hn::ApproximateReciprocal(x);
  return r * hn::NegMulAdd(x, r, set(2.0f));  // Newton
}
/// 1 / sqrt(x), relative error 2^-21. @pre  2^-100 < x < 2^100
HWY_INLINE F reciprocal_sqrt(F x) {
  const F r = hn::ApproximateReciprocalSqrt(x);
  return r * hn::NegMulAdd(x * set(0.5f) * r, r, set(1.5f));  // Newton
}

/// log2(x), relative error 2e-6 (also near 1, where the logarithm vanishes). @pre  x normal and positive
HWY_INLINE F log2(F x) {
  // x = 2^e (1 + t) with 1 + t in [sqrt(1/2), sqrt(2)); log2(1 + t) / t by a minimax polynomial of degree 6.
  const I shifted = bits_of(x) - set(0x3f3504f3);  // sqrt(1/2)
  const I e = hn::ShiftRight<23>(shifted);
  const F t = bits_of(bits_of(x) - hn::ShiftLeft<23>(e)) - set(1.0f);
  F p = fma(set(1.716245721e-1f), t, set(-2.693202190e-1f));
  p = fma(p, t, set(2.956995190e-1f));
  p = fma(p, t, set(-3.593716434e-1f));
  p = fma(p, t, set(4.806267684e-1f));
  p = fma(p, t, set(-7.213635760e-1f));
  p = fma(p, t, set(1.442696447f));
  return fma(p, t, to_float(e));
}

/// 2^x, relative error 3e-6; 0 below -126. @pre  x < 127
HWY_INLINE F exp2(F x) {
  const F clamped = hn::Max(x, set(-127.0f));
  const I k = hn::NearestInt(clamped);
  const F f = clamped - to_float(k);
  F p = fma(set(9.570101920e-3f), f, set(5.591786033e-2f));
  p = fma(p, f, set(2.402474483e-1f));
  p = fma(p, f, set(6.931218147e-1f));
  p = fma(p, f, set(9.999992614e-1f));
  const F scale = bits_of(hn::ShiftLeft<23>(k + set(127)));  // 2^k; 0 for k = -127
  return p * scale;
}

/// x^n, relative error 3e-6 + 2e-6 |log2(x^n)|: 1e-5 where the result is above 0.1, 4e-5 where it is above 1e-5.
/// 0 where x <= 0. @pre  x <= 2
HWY_INLINE F pow(F x, F n) {
  const F safe = hn::Max(x, set(1e-30f));
  return hn::IfThenElseZero(x > zero(), exp2(n * log2(safe)));
}

/// e^x, relative error 3e-6 + 1e-7 |x|; 0 below -87. @pre  x < 88
HWY_INLINE F exp(F x) { return exp2(x * set(1.442695041f)); }

/// atan(t) / t for q = t^2 in [0, 1], relative error 2e-7: a minimax polynomial of degree 7 in q.
HWY_INLINE F arc_tangent_ratio(F q) {
  F p = fma(set(-4.693276624e-3f), q, set(2.425241284e-2f));
  p = fma(p, q, set(-5.948641916e-2f));
  p = fma(p, q, set(9.914295705e-2f));
  p = fma(p, q, set(-1.401948246e-1f));
  p = fma(p, q, set(1.996972430e-1f));
  p = fma(p, q, set(-3.333199079e-1f));
  return fma(p, q, set(9.999999010e-1f));
}

}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
