// The power that a highlight is, from how far its peak is.
// Included by *_simd.cpp files after <hwy/foreach_target.h>, once for each instruction set.

#if defined(AKTINA_RASTER_SHADING_HIGHLIGHT_POWER_SIMD_H_) == defined(HWY_TARGET_TOGGLE)  // per-target include guard
#ifdef AKTINA_RASTER_SHADING_HIGHLIGHT_POWER_SIMD_H_
#undef AKTINA_RASTER_SHADING_HIGHLIGHT_POWER_SIMD_H_
#else
#define AKTINA_RASTER_SHADING_HIGHLIGHT_POWER_SIMD_H_
#endif

#include "aktina/base/simd.h"
#include "aktina/raster/shading/highlight.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {

/// The highlight over its peak. @param fall  HighlightCurve::fall()
template <bool Schlick>
HWY_INLINE F highlight_of(const HighlightCurve& curve, F fall) {
  const F one = set(1.0f), base = one - hn::Max(fall, zero());  // the cosine, or its square
  if constexpr (Schlick) {
    const F n = set(curve.exponent), t = curve.half ? hn::Sqrt(hn::Max(base, zero())) : base;
    return hn::IfThenElseZero(t > zero(), t / hn::Max(fma(one - n, t, n), set(1e-30f)));
  } else {
    return pow(base, set(curve.half ? curve.exponent / 2 : curve.exponent));
  }
}

}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
