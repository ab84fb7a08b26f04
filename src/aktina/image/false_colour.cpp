#include <algorithm>
#include <array>

#include "aktina/base/parallel.h"
#include "aktina/image/metric.h"

namespace aktina {
namespace {

/// sRGB colours from black over violet and orange to a pale yellow, evenly rising in lightness, as in the map "magma".
constexpr std::array<std::array<uint8_t, 3>, 9> kColours = {{{0, 0, 4},
                                                             {28, 16, 68},
                                                             {79, 18, 123},
                                                             {129, 37, 129},
                                                             {181, 54, 122},
                                                             {229, 80, 100},
                                                             {251, 135, 97},
                                                             {254, 194, 135},
                                                             {252, 253, 191}}};

Rgb colour(float value) {
  const float place = (value > 0 ? std::min(value, 1.0f) : 0) * float(kColours.size() - 1);  // NaN: black
  const size_t i = std::min(size_t(place), kColours.size() - 2);
  const float f = place - float(i);
  Rgb c;
  for (int k = 0; k < 3; ++k)
    c[k] = srgb_to_linear((float(kColours[i][size_t(k)]) * (1 - f) + float(kColours[i + 1][size_t(k)]) * f) / 255);
  return c;
}

}  // namespace

Image false_colour(const Image& map) {
  Image out(map.width, map.height, 3);
  parallel_for(size_t(map.height), 16, [&](size_t begin, size_t end) {
    for (int y = int(begin); y < int(end); ++y)
      for (int x = 0; x < map.width; ++x) out.set_rgb(x, y, colour(*map.at(x, y)));
  });
  return out;
}

}  // namespace aktina
