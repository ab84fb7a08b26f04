// The random numbers of one sample of one pixel: low-discrepancy points, the same whoever asks for them when.
#pragma once

#include "aktina/base/random.h"

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

}  // namespace aktina
