// sobol_owen() of base/random.h, sixteen samples at a time: the same bits.
#include "aktina/trace/sampler.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/trace/sampler_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<uint32_t, kPacket>;
using U = hn::Vec<Tag>;
constexpr Tag kUnsigned;

HWY_INLINE U set(uint32_t x) { return hn::Set(kUnsigned, x); }

HWY_INLINE U hash(U x) {
  x = (x ^ hn::ShiftRight<16>(x)) * set(0x7feb352dU);
  x = (x ^ hn::ShiftRight<15>(x)) * set(0x846ca68bU);
  return x ^ hn::ShiftRight<16>(x);
}
HWY_INLINE U combine(U a, U b) { return hash(a ^ (b + set(0x9e3779b9U) + hn::ShiftLeft<6>(a) + hn::ShiftRight<2>(a))); }

template <int kShift>
HWY_INLINE U swap_bits(U x, uint32_t mask) {
  return hn::Or(hn::ShiftLeft<kShift>(x & set(mask)), hn::ShiftRight<kShift>(x) & set(mask));
}
HWY_INLINE U reverse_bits(U x) {
  x = swap_bits<1>(x, 0x55555555U);
  x = swap_bits<2>(x, 0x33333333U);
  x = swap_bits<4>(x, 0x0f0f0f0fU);
  x = swap_bits<8>(x, 0x00ff00ffU);
  return hn::Or(hn::ShiftLeft<16>(x), hn::ShiftRight<16>(x));
}

HWY_INLINE U laine_karras(U x, U seed) {
  x = x ^ (x * set(0x3d20adeaU));
  x = x + seed;
  x = x * hn::Or(hn::ShiftRight<16>(seed), set(1));
  x = x ^ (x * set(0x05526c56U));
  return x ^ (x * set(0x53a22864U));
}
HWY_INLINE U owen_scramble(U x, U seed) { return reverse_bits(laine_karras(reverse_bits(x), seed)); }

HWY_INLINE U sobol_second(U y) {
  y = y ^ hn::ShiftLeft<1>(y & set(0x55555555U));
  y = y ^ hn::ShiftLeft<2>(y & set(0x33333333U));
  y = y ^ hn::ShiftLeft<4>(y & set(0x0f0f0f0fU));
  y = y ^ hn::ShiftLeft<8>(y & set(0x00ff00ffU));
  return y ^ hn::ShiftLeft<16>(y);
}

HWY_INLINE void store_unit(U bits, float* to) {
  const hn::Rebind<float, Tag> kFloat;
  const hn::RebindToSigned<Tag> kSigned;
  const auto whole = hn::BitCast(kSigned, hn::ShiftRight<8>(bits));  // 24 bits: positive
  hn::Store(hn::ConvertTo(kFloat, whole) * hn::Set(kFloat, 0x1p-24f), kFloat, to);
}

void SamplePairs(const SequencePacket& sequences, uint32_t offset, PairPacket& out) {
  for (size_t i = 0; i < size_t(kPacket); i += hn::Lanes(kUnsigned)) {
    const U dimension = hn::Load(kUnsigned, sequences.dimension + i) + set(offset);
    const U seed = combine(hn::Load(kUnsigned, sequences.seed + i), dimension);
    const U shuffled = owen_scramble(hn::Load(kUnsigned, sequences.index + i), hash(seed));
    const U x = reverse_bits(shuffled), y = sobol_second(x);
    store_unit(owen_scramble(x, hash(seed + set(0x9e3779b9U))), out.x + i);
    store_unit(owen_scramble(y, hash(seed + set(0x3c6ef372U))), out.y + i);
  }
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(SamplePairs);

void sample_pairs(const SequencePacket& sequences, uint32_t offset, PairPacket& out) {
  HWY_DYNAMIC_DISPATCH(SamplePairs)(sequences, offset, out);
}

}  // namespace aktina
#endif
