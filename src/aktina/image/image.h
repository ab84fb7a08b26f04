// Pictures in memory: linear float images that Aktina computes, and 8-bit bitmaps that textures come in.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "aktina/base/rgb.h"

namespace aktina {

/// Linear float image, rows from top to bottom, channels interleaved.
struct Image {
  int width = 0, height = 0, channels = 3;
  std::vector<float> pixels;  // height * width * channels

  Image() = default;
  Image(int w, int h, int c, float value = 0)
      : width(w), height(h), channels(c), pixels(size_t(w) * size_t(h) * size_t(c), value) {}

  bool empty() const { return pixels.empty(); }
  size_t offset(int x, int y) const { return (size_t(y) * size_t(width) + size_t(x)) * size_t(channels); }
  float* at(int x, int y) { return pixels.data() + offset(x, y); }
  const float* at(int x, int y) const { return pixels.data() + offset(x, y); }
  /// First three channels; grey where there are fewer.
  Rgb rgb(int x, int y) const {
    const float* p = at(x, y);
    return channels >= 3 ? Rgb{p[0], p[1], p[2]} : Rgb(p[0]);
  }
  void set_rgb(int x, int y, Rgb c) {
    float* p = at(x, y);
    p[0] = c.r, p[1] = c.g, p[2] = c.b;
  }
};

/// 8-bit image as a texture file holds it. Colours are sRGB-encoded unless `linear`; alpha is always linear.
struct Bitmap {
  int width = 0, height = 0, channels = 4;
  bool linear = false;
  std::vector<uint8_t> pixels;
};

/// A picture with named layers ("direct", "albedo", "N", ...), each an Image of the same size.
struct LayeredImage {
  struct Layer {
    std::string name;  // EXR layer name; the picture itself has the empty name
    Image image;
  };
  std::vector<Layer> layers;  // the picture first

  Image& add(std::string name, int width, int height, int channels) {
    layers.push_back({std::move(name), Image(width, height, channels)});
    return layers.back().image;
  }
  const Image* find(std::string_view name) const {
    for (const Layer& layer : layers)
      if (layer.name == name) return &layer.image;
    return nullptr;
  }
};

/// sRGB transfer functions, IEC 61966-2-1.
float srgb_to_linear(float encoded);
float linear_to_srgb(float linear);
/// The 256 values of srgb_to_linear(i / 255).
std::span<const float, 256> srgb_table();

}  // namespace aktina
