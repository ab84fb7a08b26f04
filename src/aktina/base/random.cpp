#include "aktina/base/random.h"

namespace aktina {
namespace {

constexpr uint32_t reverse_bits(uint32_t x) {
  x = ((x & 0x55555555U) << 1) | ((x >> 1) & 0x55555555U);
  x = ((x & 0x33333333U) << 2) | ((x >> 2) & 0x33333333U);
  x = ((x & 0x0f0f0f0fU) << 4) | ((x >> 4) & 0x0f0f0f0fU);
  return __builtin_bswap32(x);
}

/// Laine-Karras style hash of the reversed bits: each bit depends only on the bits below it, which is what nested
/// uniform (Owen) scrambling asks. Constants: Vegdahl, "Building a Better LK Hash", 2021.
constexpr uint32_t laine_karras(uint32_t x, uint32_t seed) {
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= (seed >> 16) | 1;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return x;
}

constexpr uint32_t owen_scramble(uint32_t x, uint32_t seed) {
  return reverse_bits(laine_karras(reverse_bits(x), seed));
}

/// Second dimension of Sobol's sequence from the (bit-reversed) index: multiplication by Pascal's triangle mod 2.
constexpr uint32_t sobol_second(uint32_t reversed) {
  uint32_t y = reversed;
  y ^= (y & 0x55555555U) << 1;
  y ^= (y & 0x33333333U) << 2;
  y ^= (y & 0x0f0f0f0fU) << 4;
  y ^= (y & 0x00ff00ffU) << 8;
  y ^= y << 16;
  return y;
}

}  // namespace

Vec2 sobol_owen(uint32_t index, uint32_t seed) {
  const uint32_t shuffled = owen_scramble(index, hash32(seed));
  const uint32_t x = reverse_bits(shuffled), y = sobol_second(x);
  return {unit_float(owen_scramble(x, hash32(seed + 0x9e3779b9U))),
          unit_float(owen_scramble(y, hash32(seed + 0x3c6ef372U)))};
}

float van_der_corput_owen(uint32_t index, uint32_t seed) {
  const uint32_t shuffled = owen_scramble(index, hash32(seed));
  return unit_float(owen_scramble(reverse_bits(shuffled), hash32(seed + 0x9e3779b9U)));
}

}  // namespace aktina
