// The random numbers of one sample of one pixel: low-discrepancy points, the same whoever asks for them when.
#pragma once

#include "aktina/base/random.h"
#include "aktina/trace/ray.h"

namespace aktina {

/// Sample `index` of a sequence. Dimensions are independent of each other, each well spread over the indices.
struct SampleSequence {
  uint32_t seed = 0;  // of the pixel
  uint32_t index = 0;
  Vec2 pair(uint32_t dimension) const { return sobol_owen(index, hash_combine(seed, dimension)); }
  float single(uint32_t dimension) const { return van_der_corput_owen(index, hash_combine(seed, dimension)); }
  /// Plain, and cheaper: for decisions that good spreading helps little.
  float random(uint32_t dimension) const {
    return unit_float(hash32(hash_combine(hash_combine(seed, dimension), index)));
  }
};

/// Sixteen sequences, each at a dimension of its own.
struct alignas(64) SequencePacket {
  uint32_t seed[kPacket] = {}, index[kPacket] = {}, dimension[kPacket] = {};
  void set(int lane, const SampleSequence& s, uint32_t d) {
    seed[lane] = s.seed, index[lane] = s.index, dimension[lane] = d;
  }
};
struct alignas(64) PairPacket {
  float x[kPacket], y[kPacket];
  Vec2 at(int lane) const { return {x[lane], y[lane]}; }
};
/// pair(dimension + offset) of each: the same numbers, many at a time.
void sample_pairs(const SequencePacket& sequences, uint32_t offset, PairPacket& out);

}  // namespace aktina
