#include "aktina/image/encoded_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "aktina/base/parallel.h"

namespace aktina {
namespace {

constexpr size_t kGrain = 1 << 14;  // pixels

/// 8-bit sRGB code of a linear value in [0, 1], as exact as by pow and faster: a table finds a code at or
/// below the right one, the thresholds between neighbouring codes decide.
class SrgbCode {
 public:
  SrgbCode() {
    for (size_t code = 0; code < 256; ++code) upper_[code] = srgb_to_linear((float(code) + 0.5f) / 255);
    upper_[255] = 2;
    for (size_t i = 0, code = 0; i < first_.size(); ++i) {
      while (float(i) / kCells >= upper_[code]) ++code;
      first_[i] = uint8_t(code);
    }
  }
  uint8_t operator()(float linear) const {
    size_t code = first_[size_t(linear * kCells)];
    while (linear >= upper_[code]) ++code;
    return uint8_t(code);
  }

 private:
  static constexpr int kCells = 4096;
  std::array<float, 256> upper_;  // the smallest linear value of the next code
  std::array<uint8_t, kCells + 1> first_;
};

void put(uint8_t& code, float linear) {
  static const SrgbCode encoder;
  code = encoder(linear);
}
void put(uint16_t& code, float linear) { code = uint16_t(std::lround(linear_to_srgb(linear) * 65535)); }

template <class Code>
Code alpha_code(float alpha) {
  constexpr float kTop = Code(-1);
  return Code(std::lround(std::min(std::max(0.0f, alpha), 1.0f) * kTop));
}

template <class Code>
void decode(std::span<const Code> codes, size_t stride, std::span<const float> table, Image& image) {
  const auto channels = size_t(image.channels), colours = channels - (channels % 2 == 0);
  parallel_for(image.pixels.size() / channels, kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      for (size_t c = 0; c < colours; ++c) image.pixels[i * channels + c] = table[codes[i * stride + c]];
      if (colours < channels) image.pixels[i * channels + colours] = float(codes[i * stride + stride - 1]) / Code(-1);
    }
  });
}

template <class Code>
void encode(const Image& image, const ToneMapping& mapping, std::span<Code> codes) {
  const float exposure = mapping.exposure > 0 ? mapping.exposure : automatic_exposure(image);
  const auto channels = size_t(image.channels), colours = channels - (channels % 2 == 0);
  parallel_for(codes.size() / channels, kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const float* in = &image.pixels[i * channels];
      Code* out = &codes[i * channels];
      const Rgb colour = tone_map(colours == 3 ? Rgb{in[0], in[1], in[2]} : Rgb(in[0]), exposure, mapping.curve);
      for (size_t c = 0; c < colours; ++c) put(out[c], colour[int(c)]);
      if (colours < channels) out[colours] = alpha_code<Code>(in[colours]);
    }
  });
}

}  // namespace

std::vector<float> decoding_table(int bits, double exponent) {
  std::vector<float> table(size_t(1) << bits);
  for (size_t i = 0; i < table.size(); ++i) {
    const double code = double(i) / double(table.size() - 1);
    table[i] = exponent > 0 ? float(std::pow(code, exponent)) : srgb_to_linear(float(code));
  }
  return table;
}

void decode_colours(std::span<const uint8_t> codes, size_t stride, std::span<const float> table, Image& image) {
  decode(codes, stride, table, image);
}
void decode_colours(std::span<const uint16_t> codes, size_t stride, std::span<const float> table, Image& image) {
  decode(codes, stride, table, image);
}

void encode_colours(const Image& image, const ToneMapping& mapping, std::span<uint8_t> codes) {
  encode(image, mapping, codes);
}
void encode_colours(const Image& image, const ToneMapping& mapping, std::span<uint16_t> codes) {
  encode(image, mapping, codes);
}

}  // namespace aktina
