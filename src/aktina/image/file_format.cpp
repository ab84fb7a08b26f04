#include "aktina/image/file_format.h"

#include <fmt/core.h>

#include <cstring>

#include "aktina/base/error.h"
#include "aktina/image/codec.h"

namespace aktina {
namespace {

constexpr const ImageCodec* kCodecs[] = {&png_codec,      &jpeg_codec,         &webp_codec,
                                         &open_exr_codec, &radiance_hdr_codec, &pfm_codec};

constexpr uint64_t kAlwaysAccepted = uint64_t(64) << 20;  // bytes of decoded pixels
constexpr uint64_t kBestPacking = 1100;                   // deflate reaches 1032 : 1

const ImageCodec* find_codec(Bytes bytes) {
  for (const ImageCodec* codec : kCodecs)
    if (codec->recognizes(bytes)) return codec;
  return nullptr;
}

const ImageCodec& codec_of(Bytes bytes, const std::string& where) {
  if (bytes.empty()) throw Error(Code::bad_input, where, "is empty");
  if (const ImageCodec* codec = find_codec(bytes)) return *codec;
  throw Error(Code::bad_input, where, "is no image that Aktina reads", "PNG, JPEG, WebP, Radiance HDR, OpenEXR or PFM");
}

const ImageCodec& codec_for_writing(const Path& path) {
  const std::string extension = lower_extension(path);
  std::string known;
  for (const ImageCodec* codec : kCodecs) {
    if (!codec->encode) continue;
    if (codec->name == extension) return *codec;
    known += fmt::format("{}.{}", known.empty() ? "" : ", ", codec->name);
  }
  throw Error(Code::usage, display(path), "cannot tell the image format from the name", "one of " + known);
}

void check_picture(const LayeredImage& picture, const std::string& where) {
  if (picture.layers.empty()) throw Error(Code::usage, where, "the picture has no layers");
  const Image& first = picture.layers[0].image;
  for (const LayeredImage::Layer& layer : picture.layers) {
    const Image& image = layer.image;
    if (image.width <= 0 || image.height <= 0 || image.channels < 1 || image.channels > 4)
      throw Error(Code::usage, where,
                  fmt::format("the picture is {} x {} with {} channels", image.width, image.height, image.channels),
                  "at least 1 x 1, with 1 to 4 channels");
    if (image.width != first.width || image.height != first.height)
      throw Error(Code::usage, where, fmt::format("layer '{}' has another size than the picture", layer.name));
  }
}

}  // namespace

bool starts_with(Bytes bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

void check_image_size(uint64_t width, uint64_t height, uint64_t bytes_per_pixel, size_t encoded,
                      const std::string& where) {
  if (width == 0 || height == 0) throw Error(Code::bad_input, where, "has no pixels");
  if (width > kMostPixels || height > kMostPixels / width)
    throw Error(Code::limit, where, fmt::format("claims {} x {} pixels", width, height),
                fmt::format("at most {} in all", kMostPixels));
  const uint64_t decoded = width * height * bytes_per_pixel;
  if (decoded > kAlwaysAccepted && decoded / kBestPacking > encoded)
    throw Error(Code::limit, where, fmt::format("claims {} x {} pixels in {} bytes", width, height, encoded),
                "the file is damaged, or made to exhaust memory");
}

ImageFormat detect_image_format(Bytes bytes) {
  const ImageCodec* codec = find_codec(bytes);
  return codec ? codec->format : ImageFormat::unknown;
}

ImageHeader read_image_header(Bytes bytes, const std::string& where) {
  return codec_of(bytes, where).header(bytes, where);
}

Image decode_image(Bytes bytes, const std::string& where) { return codec_of(bytes, where).decode(bytes, where); }

Image read_image(const Path& path) { return decode_image(read_file(path), display(path)); }

LayeredImage read_layered_image(const Path& path) { return decode_layered_image(read_file(path), display(path)); }

LayeredImage decode_layered_image(Bytes bytes, const std::string& where) {
  const ImageCodec& codec = codec_of(bytes, where);
  if (codec.layers) return codec.layers(bytes, where);
  LayeredImage picture;
  picture.layers.push_back({"", codec.decode(bytes, where)});
  return picture;
}

std::variant<Bitmap, Image> decode_texture(Bytes bytes, const std::string& where) {
  const ImageCodec& codec = codec_of(bytes, where);
  if (codec.texture) return codec.texture(bytes, where);
  return codec.decode(bytes, where);
}

void write_image(const Path& path, const LayeredImage& picture, const ImageWriteOptions& options) {
  const ImageCodec& codec = codec_for_writing(path);
  check_picture(picture, display(path));
  write_file(path, codec.encode(picture, options));
}

void write_image(const Path& path, const Image& picture, const ImageWriteOptions& options) {
  LayeredImage layered;
  layered.layers.push_back({"", picture});
  write_image(path, layered, options);
}

}  // namespace aktina
