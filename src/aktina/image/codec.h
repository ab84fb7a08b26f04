// One row per file format; image/file_format.cpp lists them. Each codec is one file that says nothing about the others.
#pragma once

#include "aktina/image/file_format.h"

namespace aktina {

using Bytes = std::span<const uint8_t>;

struct ImageCodec {
  ImageFormat format;
  std::string_view name;  // in messages, and the extension of what it writes
  bool (*recognizes)(Bytes bytes);
  ImageHeader (*header)(Bytes bytes, const std::string& where);
  Image (*decode)(Bytes bytes, const std::string& where);
  LayeredImage (*layers)(Bytes bytes, const std::string& where);                  // null: decode() alone
  std::variant<Bitmap, Image> (*texture)(Bytes bytes, const std::string& where);  // null: decode()
  std::vector<uint8_t> (*encode)(const LayeredImage& picture, const ImageWriteOptions& options);  // null: read only
};

extern const ImageCodec png_codec, jpeg_codec, webp_codec, radiance_hdr_codec, open_exr_codec, pfm_codec;

/// To be called before memory is taken for pixels.
/// @param bytes_per_pixel  of the decoded form
/// @param encoded          bytes of the file. A claim that they cannot possibly hold is refused: no format here packs
///                         better than about 1000 : 1 (but for single colours, which stay below the size that is
///                         always accepted).
/// @throws Error bad_input (no pixels), limit
void check_image_size(uint64_t width, uint64_t height, uint64_t bytes_per_pixel, size_t encoded,
                      const std::string& where);

bool starts_with(Bytes bytes, std::string_view magic);

}  // namespace aktina
