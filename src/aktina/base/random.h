// Random and low-discrepancy numbers: counter-based, so that a sample does not depend on who draws it when.
#pragma once

#include <cstdint>

#include "aktina/base/vec.h"

namespace aktina {

/// A well-mixed hash of 32 bits. Wellons, "Prospecting for Hash Functions", 2018 (lowbias32).
constexpr uint32_t hash32(uint32_t x) {
  x ^= x >> 16, x *= 0x7feb352dU, x ^= x >> 15, x *= 0x846ca68bU, x ^= x >> 16;
  return x;
}
constexpr uint32_t hash_combine(uint32_t a, uint32_t b) { return hash32(a ^ (b + 0x9e3779b9U + (a << 6) + (a >> 2))); }

/// [0, 1), 24 bits.
constexpr float unit_float(uint32_t bits) { return float(bits >> 8) * 0x1p-24f; }

/// O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms", 2014 (pcg32, XSH-RR).
class Pcg32 {
 public:
  explicit constexpr Pcg32(uint64_t seed, uint64_t stream = 0) : state_(0), increment_((stream << 1) | 1) {
    next();
    state_ += seed;
    next();
  }
  constexpr uint32_t next() {
    const uint64_t old = state_;
    state_ = old * 6364136223846793005ULL + increment_;
    const auto shifted = uint32_t(((old >> 18) ^ old) >> 27);
    const auto turn = uint32_t(old >> 59);
    return (shifted >> turn) | (shifted << ((32 - turn) & 31));
  }
  constexpr float uniform() { return unit_float(next()); }
  constexpr double uniform_double() {
    const uint64_t high = next();
    return double((high << 21) ^ (next() >> 11)) * 0x1p-53;
  }

 private:
  uint64_t state_, increment_;
};

/// Two dimensions of the Sobol sequence, Owen-scrambled by `seed`: sample `index` of a pair of dimensions.
/// Different `seed` (hash of pixel and pair) gives independent, equally well-spread points.
/// Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020; with Vegdahl's permutation constants.
Vec2 sobol_owen(uint32_t index, uint32_t seed);

/// Radical inverse of `index` in base 2 (van der Corput), scrambled by `seed` as above.
float van_der_corput_owen(uint32_t index, uint32_t seed);

/// Direction about +z with density cos / pi. sr^-1
inline Vec3 sample_cosine_hemisphere(Vec2 u) {
  const float r = __builtin_sqrtf(u.x), phi = 2 * float(kPi) * u.y;
  return {r * __builtin_cosf(phi), r * __builtin_sinf(phi), __builtin_sqrtf(1 - u.x > 0 ? 1 - u.x : 0)};
}

}  // namespace aktina
