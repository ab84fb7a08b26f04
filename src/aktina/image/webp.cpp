// WebP, by libwebp: still pictures, lossy or lossless. Colours are taken as sRGB; profiles are not applied.
#include <webp/decode.h>

#include "aktina/base/error.h"
#include "aktina/image/codec.h"
#include "aktina/image/encoded_colour.h"

namespace aktina {
namespace {

WebPBitstreamFeatures features(Bytes bytes, const std::string& where) {
  WebPBitstreamFeatures found;
  const VP8StatusCode status = WebPGetFeatures(bytes.data(), bytes.size(), &found);
  if (status == VP8_STATUS_NOT_ENOUGH_DATA) throw Error(Code::bad_input, where, "the WebP is truncated");
  if (status != VP8_STATUS_OK) throw Error(Code::bad_input, where, "broken WebP");
  if (found.has_animation) throw Error(Code::unsupported, where, "is an animation", "save one frame of it");
  check_image_size(uint64_t(found.width), uint64_t(found.height), 4, bytes.size(), where);
  return found;
}

Bitmap rgba(Bytes bytes, const WebPBitstreamFeatures& file, const std::string& where) {
  Bitmap bitmap{file.width, file.height, 4, false, {}};
  bitmap.pixels.resize(size_t(file.width) * size_t(file.height) * 4);
  if (!WebPDecodeRGBAInto(bytes.data(), bytes.size(), bitmap.pixels.data(), bitmap.pixels.size(), file.width * 4))
    throw Error(Code::bad_input, where, "the WebP is truncated or broken");
  return bitmap;
}

ImageHeader header(Bytes bytes, const std::string& where) {
  const WebPBitstreamFeatures file = features(bytes, where);
  return {ImageFormat::webp, file.width, file.height, file.has_alpha ? 4 : 3, 8, {}};
}

Image decode(Bytes bytes, const std::string& where) {
  const WebPBitstreamFeatures file = features(bytes, where);
  Image image(file.width, file.height, file.has_alpha ? 4 : 3);
  decode_colours(rgba(bytes, file, where).pixels, 4, srgb_table(), image);
  return image;
}

std::variant<Bitmap, Image> texture(Bytes bytes, const std::string& where) {
  return rgba(bytes, features(bytes, where), where);
}

bool recognizes(Bytes bytes) {
  return bytes.size() >= 12 && starts_with(bytes, "RIFF") && starts_with(bytes.subspan(8), "WEBP");
}

}  // namespace

extern constinit const ImageCodec webp_codec = {ImageFormat::webp, "webp",  recognizes, header, decode,
                                                nullptr,           texture, nullptr};

}  // namespace aktina
