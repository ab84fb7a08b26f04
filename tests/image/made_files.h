// Files of the formats that Aktina reads but does not write, made by the formats' own libraries.
#pragma once

#include <turbojpeg.h>
#include <webp/encode.h>

#include <cstdint>
#include <vector>

namespace aktina::test {

/// @param codes  width * height pixels of `format`
inline std::vector<uint8_t> made_jpeg(int width, int height, std::vector<uint8_t> codes, int format = TJPF_RGB,
                                      int flags = 0) {
  const tjhandle handle = tjInitCompress();
  unsigned char* out = nullptr;
  unsigned long size = 0;
  const int subsampling = format == TJPF_GRAY ? TJSAMP_GRAY : TJSAMP_444;
  tjCompress2(handle, codes.data(), width, 0, height, format, &out, &size, subsampling, 95, flags);
  std::vector<uint8_t> bytes(out, out + size);
  tjFree(out);
  tjDestroy(handle);
  return bytes;
}

inline std::vector<uint8_t> made_webp(int width, int height, std::vector<uint8_t> rgba, bool lossless = true) {
  uint8_t* out = nullptr;
  const size_t size = lossless ? WebPEncodeLosslessRGBA(rgba.data(), width, height, 4 * width, &out)
                               : WebPEncodeRGBA(rgba.data(), width, height, 4 * width, 90, &out);
  std::vector<uint8_t> bytes(out, out + size);
  WebPFree(out);
  return bytes;
}

/// Codes that differ from pixel to pixel.
inline std::vector<uint8_t> codes(size_t count) {
  std::vector<uint8_t> values(count);
  for (size_t i = 0; i < count; ++i) values[i] = uint8_t(i * i / 7 + i * 13);
  return values;
}

}  // namespace aktina::test
