// Between linear light and the whole numbers that 8 and 16 bit files hold.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aktina/image/image.h"
#include "aktina/image/tone_map.h"

namespace aktina {

/// Linear value of each of the 2^bits code values.
/// @param exponent  linear = code^exponent; 0: sRGB
std::vector<float> decoding_table(int bits, double exponent = 0);

/// Colour channels through `table`, the last of 2 or 4 channels (alpha) linearly.
/// @param codes  `stride` values per pixel, of which the picture takes its own
void decode_colours(std::span<const uint8_t> codes, size_t stride, std::span<const float> table, Image& image);
void decode_colours(std::span<const uint16_t> codes, size_t stride, std::span<const float> table, Image& image);

/// Exposed, tone-mapped and sRGB-encoded, rounded to the nearest code; alpha is clipped to [0, 1].
void encode_colours(const Image& image, const ToneMapping& mapping, std::span<uint8_t> codes);
void encode_colours(const Image& image, const ToneMapping& mapping, std::span<uint16_t> codes);

}  // namespace aktina
