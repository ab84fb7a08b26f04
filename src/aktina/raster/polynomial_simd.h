// What the planes of a triangle say at the pixels of a block.
// Included by *_simd.cpp files after "aktina/base/simd.h", once for each instruction set.

#if defined(AKTINA_RASTER_POLYNOMIAL_SIMD_H_) == defined(HWY_TARGET_TOGGLE)  // per-target include guard
#ifdef AKTINA_RASTER_POLYNOMIAL_SIMD_H_
#undef AKTINA_RASTER_POLYNOMIAL_SIMD_H_
#else
#define AKTINA_RASTER_POLYNOMIAL_SIMD_H_
#endif

#include "aktina/base/simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {

HWY_INLINE F plane_at(const float* p, F x, F y) { return fma(set(p[1]), x, fma(set(p[2]), y, set(p[0]))); }

/// A polynomial of `Degree`, coefficients as lattice_to_polynomial() has them.
template <int Degree>
HWY_INLINE F polynomial_at(const float* c, F u, F v) {
  if constexpr (Degree == 0) return set(c[0]);
  if constexpr (Degree == 1) return plane_at(c, u, v);
  F sum = set(c[5]) * v;
  if constexpr (Degree == 3) sum = fma(fma(set(c[9]), v, set(c[8]) * u), v, sum);
  sum = fma(sum, v, set(c[2]) * v);  // c2 v + c5 v^2 (+ c8 u v^2 + c9 v^3)
  F in_u = fma(set(c[3]), u, fma(set(c[4]), v, set(c[1])));
  if constexpr (Degree == 3) in_u = fma(fma(set(c[6]), u, set(c[7]) * v), u, in_u);
  return fma(in_u, u, sum) + set(c[0]);
}

}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
