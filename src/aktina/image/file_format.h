// Image files: PNG, JPEG, WebP, Radiance HDR, OpenEXR in; PNG, EXR, HDR, PFM out.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>

#include "aktina/base/file.h"
#include "aktina/image/image.h"
#include "aktina/image/tone_map.h"

namespace aktina {

/// Pixels that an image may have at most; larger claims are refused before memory is taken.
inline constexpr uint64_t kMostPixels = uint64_t(1) << 28;

enum class ImageFormat { unknown, png, jpeg, webp, hdr, exr, pfm };

/// By the first bytes, never by the name.
ImageFormat detect_image_format(std::span<const uint8_t> bytes);

/// What a header says, without decoding pixels.
struct ImageHeader {
  ImageFormat format = ImageFormat::unknown;
  int width = 0, height = 0, channels = 0;
  int bits = 8;                     // per channel
  std::vector<std::string> layers;  // EXR layer names
};

/// @throws Error bad_input (truncated, corrupt), limit (too many pixels), unsupported
ImageHeader read_image_header(std::span<const uint8_t> bytes, const std::string& where);

/// Linear float picture of any supported format; 8-bit and 16-bit colours are decoded from sRGB. EXR: the root RGB(A)
/// or Y layer. @throws as above
Image read_image(const Path& path);
Image decode_image(std::span<const uint8_t> bytes, const std::string& where);
/// All layers of an EXR file; other formats have one.
LayeredImage read_layered_image(const Path& path);
LayeredImage decode_layered_image(std::span<const uint8_t> bytes, const std::string& where);

/// A texture: PNG (8 and 16 bit), JPEG or WebP as 8-bit RGBA, still sRGB-encoded; HDR and EXR as a float Image.
std::variant<Bitmap, Image> decode_texture(std::span<const uint8_t> bytes, const std::string& where);

/// How a picture is written; what a format has no use for is ignored.
struct ImageWriteOptions {
  ToneMapping tone_mapping;                                   // PNG
  int png_bits = 8;                                           // 8 or 16
  std::vector<std::pair<std::string, std::string>> metadata;  // PNG tEXt, EXR attributes, HDR comments
};

/// By the extension: png (tone-mapped sRGB), exr (linear half or float, layers kept), hdr, pfm.
/// @throws Error usage (unknown extension), io
void write_image(const Path& path, const LayeredImage& picture, const ImageWriteOptions& options = {});
void write_image(const Path& path, const Image& picture, const ImageWriteOptions& options = {});

}  // namespace aktina
