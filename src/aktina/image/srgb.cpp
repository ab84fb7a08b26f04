#include <array>
#include <cmath>

#include "aktina/image/image.h"

namespace aktina {

float srgb_to_linear(float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }

float linear_to_srgb(float v) { return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f; }

std::span<const float, 256> srgb_table() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t{};
    for (size_t i = 0; i < t.size(); ++i) t[i] = srgb_to_linear(float(i) / 255);
    return t;
  }();
  return table;
}

}  // namespace aktina
