// Pictures that the tests of files and metrics share.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "aktina/base/error.h"
#include "aktina/image/file_format.h"
#include "test_files.h"

namespace aktina::test {

/// Values in [0, top), different in every channel and pixel.
inline Image noise(int width, int height, int channels, float top = 1, uint32_t seed = 1) {
  Image image(width, height, channels);
  uint32_t state = seed;
  for (float& value : image.pixels) {
    state = state * 1664525u + 1013904223u;
    value = top * float(state >> 8) / float(1 << 24);
  }
  return image;
}

/// What `write_image` makes of a picture in the format of `extension`.
inline std::vector<uint8_t> written(const LayeredImage& picture, const std::string& extension,
                                    const ImageWriteOptions& options = {}) {
  const TemporaryFolder folder;
  const Path path = folder / ("picture." + extension);
  write_image(path, picture, options);
  return read_file(path);
}
inline std::vector<uint8_t> written(const Image& image, const std::string& extension,
                                    const ImageWriteOptions& options = {}) {
  LayeredImage picture;
  picture.layers.push_back({"", image});
  return written(picture, extension, options);
}

inline std::vector<uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

/// The error that decoding ends with; fails the test if there is none.
inline Code decode_error(std::span<const uint8_t> bytes) {
  try {
    decode_image(bytes, "test");
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find("test: "), 0u) << error.what();
    return error.code();
  }
  ADD_FAILURE() << "decoded";
  return Code::cancelled;
}

}  // namespace aktina::test
