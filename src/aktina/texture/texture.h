// What a material's picture says at a point.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "aktina/base/vec.h"
#include "aktina/image/image.h"

namespace aktina {

enum class Wrap : uint8_t { repeat, mirror, clamp };
enum class Filter : uint8_t { bilinear, nearest };

/// A picture that materials share. Bitmaps stay 8 bit in memory.
struct TextureImage {
  std::string name;
  std::string uri;               // where it came from; empty for embedded ones
  std::string media_type;        // "image/png"
  std::vector<uint8_t> encoded;  // the file's own bytes, kept for export
  std::variant<Bitmap, Image> pixels;
  int width() const {
    return std::visit([](const auto& p) { return p.width; }, pixels);
  }
  int height() const {
    return std::visit([](const auto& p) { return p.height; }, pixels);
  }
};

/// Use of a picture by a material: glTF's textureInfo with KHR_texture_transform and sampler.
struct Texture {
  int image = -1;  // index into Scene::images; -1: none
  int uv_set = 0;
  Vec2 offset{0}, scale{1};
  float rotation = 0;  // rad, counter-clockwise about the uv origin
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  Filter filter = Filter::bilinear;
  explicit operator bool() const { return image >= 0; }
};

/// RGBA at uv (v down, as glTF has it). `colour`: decode sRGB to linear; data textures are read as they are.
/// Texel centres lie at (i + 0.5) / width; bilinear filtering is of linear values.
Vec4 look_up(const TextureImage& image, const Texture& use, Vec2 uv, bool colour);

}  // namespace aktina
