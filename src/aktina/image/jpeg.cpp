// JPEG, by libjpeg-turbo: grey, colour, and the inverted CMYK that Adobe's programs write. Colours are taken as sRGB;
// profiles and the orientation in Exif data are not applied, as glTF wants it. A file with damaged or missing data is
// refused, although the decoder would make up the rest.
#include <turbojpeg.h>

#include <memory>

#include "aktina/base/error.h"
#include "aktina/image/codec.h"
#include "aktina/image/encoded_colour.h"

namespace aktina {
namespace {

/// Warnings about bytes between segments, which do not touch the picture.
bool is_harmless(std::string_view warning) {
  return warning.find("extraneous bytes") != warning.npos || warning.find("unknown revision") != warning.npos ||
         warning.find("Unknown Adobe color transform") != warning.npos;
}

struct Decoder {
  std::unique_ptr<void, decltype(&tjDestroy)> handle{tjInitDecompress(), &tjDestroy};
  int width = 0, height = 0, colour_space = 0;
  Bytes bytes;
  const std::string& where;

  Decoder(Bytes file, const std::string& place) : bytes(file), where(place) {
    int subsampling = 0;
    check(tjDecompressHeader3(handle.get(), bytes.data(), bytes.size(), &width, &height, &subsampling, &colour_space));
    check_image_size(uint64_t(width), uint64_t(height), 4, bytes.size(), where);
  }

  bool grey() const { return colour_space == TJCS_GRAY; }
  bool cmyk() const { return colour_space == TJCS_CMYK || colour_space == TJCS_YCCK; }

  std::vector<uint8_t> pixels(TJPF format) const {
    std::vector<uint8_t> codes(size_t(width) * size_t(height) * size_t(tjPixelSize[format]));
    check(tjDecompress2(handle.get(), bytes.data(), bytes.size(), codes.data(), width, 0, height, format,
                        TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS));
    return codes;
  }

  /// RGBA, opaque.
  std::vector<uint8_t> rgba() const {
    if (!cmyk()) return pixels(TJPF_RGBA);
    std::vector<uint8_t> codes = pixels(TJPF_CMYK);
    for (size_t i = 0; i < codes.size(); i += 4) {
      const unsigned key = codes[i + 3];
      for (size_t c = 0; c < 3; ++c) codes[i + c] = uint8_t((codes[i + c] * key + 127) / 255);
      codes[i + 3] = 255;
    }
    return codes;
  }

 private:
  void check(int status) const {
    if (status == 0) return;
    const std::string_view said = tjGetErrorStr2(handle.get());
    if (tjGetErrorCode(handle.get()) == TJERR_WARNING && is_harmless(said)) return;
    throw Error(Code::bad_input, where, "broken JPEG: " + std::string(said));
  }
};

ImageHeader header(Bytes bytes, const std::string& where) {
  const Decoder file(bytes, where);
  return {ImageFormat::jpeg, file.width, file.height, file.grey() ? 1 : 3, 8, {}};
}

Image decode(Bytes bytes, const std::string& where) {
  const Decoder file(bytes, where);
  const std::vector<uint8_t> codes = file.grey() ? file.pixels(TJPF_GRAY) : file.rgba();
  Image image(file.width, file.height, file.grey() ? 1 : 3);
  decode_colours(codes, file.grey() ? 1 : 4, srgb_table(), image);
  return image;
}

std::variant<Bitmap, Image> texture(Bytes bytes, const std::string& where) {
  const Decoder file(bytes, where);
  return Bitmap{file.width, file.height, 4, false, file.rgba()};
}

bool recognizes(Bytes bytes) { return starts_with(bytes, "\xff\xd8\xff"); }

}  // namespace

extern constinit const ImageCodec jpeg_codec = {ImageFormat::jpeg, "jpeg",  recognizes, header, decode,
                                                nullptr,           texture, nullptr};

}  // namespace aktina
