// PFM: "PF" (colour) or "Pf" (grey), width, height and a scale in text, then 32-bit floats, lowest row first. The sign
// of the scale is the order of the bytes (negative: little-endian); its size is a unit of the writer's and is not
// applied.
//
// P. Debevec, "HDRI and Light Probes", pauldebevec.com/Research/HDR/PFM/, 1999.
#include <fmt/core.h>

#include <bit>
#include <charconv>
#include <cstring>

#include "aktina/base/error.h"
#include "aktina/image/codec.h"

namespace aktina {
namespace {

struct Layout {
  int width, height, channels;
  bool little_endian;
  size_t first;  // byte of the pixels
};

bool is_blank(uint8_t c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

/// The next word, and exactly one blank after it.
std::string_view word(Bytes bytes, size_t& position, const std::string& where) {
  while (position < bytes.size() && is_blank(bytes[position])) ++position;
  const size_t begin = position;
  while (position < bytes.size() && !is_blank(bytes[position])) ++position;
  if (position == bytes.size()) throw Error(Code::bad_input, where, "ends in its header");
  return {reinterpret_cast<const char*>(bytes.data()) + begin, position++ - begin};
}

template <class T>
T number(Bytes bytes, size_t& position, const std::string& where) {
  const std::string_view text = word(bytes, position, where);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw Error(Code::bad_input, where, fmt::format("'{}' in the header is no number", text.substr(0, 40)));
  return value;
}

Layout layout(Bytes bytes, const std::string& where) {
  Layout layout{};
  size_t position = 0;
  layout.channels = word(bytes, position, where) == "PF" ? 3 : 1;
  const auto width = number<uint32_t>(bytes, position, where), height = number<uint32_t>(bytes, position, where);
  const auto scale = number<float>(bytes, position, where);
  const uint64_t pixel = 4 * uint64_t(layout.channels);
  check_image_size(width, height, pixel, bytes.size(), where);
  if (bytes.size() - position < width * height * pixel) throw Error(Code::bad_input, where, "is truncated");
  layout.width = int(width), layout.height = int(height);
  layout.little_endian = scale < 0;
  layout.first = position;
  return layout;
}

bool recognizes(Bytes bytes) {
  return bytes.size() > 3 && (starts_with(bytes, "PF") || starts_with(bytes, "Pf")) && is_blank(bytes[2]);
}

ImageHeader header(Bytes bytes, const std::string& where) {
  const Layout file = layout(bytes, where);
  return {ImageFormat::pfm, file.width, file.height, file.channels, 32, {}};
}

Image decode(Bytes bytes, const std::string& where) {
  const Layout file = layout(bytes, where);
  Image image(file.width, file.height, file.channels);
  const size_t row = size_t(file.width) * size_t(file.channels) * 4;
  for (int y = 0; y < file.height; ++y)
    std::memcpy(image.at(0, y), bytes.data() + file.first + row * size_t(file.height - 1 - y), row);
  if (!file.little_endian)
    for (float& value : image.pixels) value = std::bit_cast<float>(__builtin_bswap32(std::bit_cast<uint32_t>(value)));
  return image;
}

std::vector<uint8_t> encode(const LayeredImage& picture, const ImageWriteOptions&) {
  const Image& image = picture.layers[0].image;
  const int channels = image.channels >= 3 ? 3 : 1;
  const std::string text = fmt::format("{}\n{} {}\n-1.0\n", channels == 3 ? "PF" : "Pf", image.width, image.height);
  const size_t pixel = size_t(channels) * 4;
  std::vector<uint8_t> bytes(text.size() + size_t(image.width) * size_t(image.height) * pixel);
  std::memcpy(bytes.data(), text.data(), text.size());
  uint8_t* out = bytes.data() + text.size();
  for (int y = image.height; y-- > 0;)
    for (int x = 0; x < image.width; ++x, out += pixel) std::memcpy(out, image.at(x, y), pixel);
  return bytes;
}

}  // namespace

extern constinit const ImageCodec pfm_codec = {ImageFormat::pfm, "pfm",   recognizes, header,
                                               decode,           nullptr, nullptr,    encode};

}  // namespace aktina
