// Screen coordinates in the SIMD code: 32-bit integers whose products are exact in double.
// Included by *_simd.cpp files after "aktina/base/simd.h", once for each instruction set.

#if defined(AKTINA_RASTER_EXACT_SIMD_H_) == defined(HWY_TARGET_TOGGLE)  // per-target include guard
#ifdef AKTINA_RASTER_EXACT_SIMD_H_
#undef AKTINA_RASTER_EXACT_SIMD_H_
#else
#define AKTINA_RASTER_EXACT_SIMD_H_
#endif

#include "aktina/base/simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {

using DoubleTag = hn::CappedTag<double, 16>;
using NarrowIntTag = hn::Rebind<int32_t, DoubleTag>;
using NarrowFloatTag = hn::Rebind<float, DoubleTag>;
using D = hn::Vec<DoubleTag>;
using NI = hn::Vec<NarrowIntTag>;    // as many lanes as D
using NF = hn::Vec<NarrowFloatTag>;  // as many lanes as D
using NM = hn::Mask<NarrowIntTag>;
inline constexpr DoubleTag kDouble;
inline constexpr NarrowIntTag kNarrowInt;
inline constexpr NarrowFloatTag kNarrowFloat;
inline constexpr size_t kWidePart = hn::MaxLanes(DoubleTag());

HWY_INLINE D wide(NI v) { return hn::PromoteTo(kDouble, v); }
HWY_INLINE D wide(double x) { return hn::Set(kDouble, x); }
HWY_INLINE NI narrow_set(int32_t x) { return hn::Set(kNarrowInt, x); }
HWY_INLINE NF to_narrow_float(D v) { return hn::DemoteTo(kNarrowFloat, v); }
HWY_INLINE NI floor_to_int(D v) { return hn::DemoteTo(kNarrowInt, hn::Floor(v)); }
HWY_INLINE NI narrow_load(const int32_t* p) { return hn::LoadU(kNarrowInt, p); }
HWY_INLINE NI narrow_load(const uint32_t* p) { return hn::LoadU(kNarrowInt, reinterpret_cast<const int32_t*>(p)); }
HWY_INLINE NF narrow_load(const float* p) { return hn::LoadU(kNarrowFloat, p); }

/// Bit i: lane i of the mask.
template <class Tag>
HWY_INLINE uint32_t narrow_bits(Tag tag, hn::Mask<Tag> m) {
  uint8_t bytes[8] = {};
  hn::StoreMaskBits(tag, m, bytes);
  return uint32_t(bytes[0]) & ((1U << kWidePart) - 1);
}

}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
