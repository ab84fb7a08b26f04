#include "aktina/texture/texture.h"

#include <cmath>

namespace aktina {
namespace {

constexpr float kFarthest = 1e9f;  // coordinates beyond it, and NaN, say nothing

/// KHR_texture_transform: scaled, turned (counter-clockwise as seen, v pointing down), then moved.
Vec2 transformed(const Texture& use, Vec2 uv) {
  uv *= use.scale;
  if (use.rotation != 0) {
    const float c = std::cos(use.rotation), s = std::sin(use.rotation);
    uv = {c * uv.x + s * uv.y, c * uv.y - s * uv.x};
  }
  return uv + use.offset;
}

/// Texel index for any whole number `i`.
int wrapped(Wrap wrap, float i, int size) {
  const auto n = float(size);
  if (wrap == Wrap::clamp) return int(i < 0 ? 0 : i > n - 1 ? n - 1 : i);
  const float period = wrap == Wrap::mirror ? 2 * n : n;
  i -= std::floor(i / period) * period;
  if (i >= n && wrap == Wrap::mirror) i = period - 1 - i;
  const int texel = int(i);
  return texel < 0 ? 0 : texel >= size ? size - 1 : texel;  // rounding of the floor at very large coordinates
}

Vec4 texel(const Bitmap& bitmap, int x, int y, bool colour) {
  const int channels = bitmap.channels;
  const uint8_t* p = bitmap.pixels.data() + (size_t(y) * size_t(bitmap.width) + size_t(x)) * size_t(channels);
  const int colours = channels >= 3 ? 3 : 1;
  Vec4 v(1);
  for (int k = 0; k < colours; ++k) v[k] = colour && !bitmap.linear ? srgb_table()[p[k]] : float(p[k]) * (1 / 255.0f);
  if (colours == 1) v.y = v.z = v.x;
  if (channels == 2 || channels == 4) v.w = float(p[channels - 1]) * (1 / 255.0f);
  return v;
}

Vec4 texel(const Image& image, int x, int y, bool) {
  const float* p = image.at(x, y);
  const Rgb c = image.rgb(x, y);
  return {c.r, c.g, c.b, image.channels == 2 || image.channels == 4 ? p[image.channels - 1] : 1};
}

template <class Pixels>
Vec4 filtered(const Pixels& pixels, const Texture& use, Vec2 uv, bool colour) {
  const float x = uv.x * float(pixels.width), y = uv.y * float(pixels.height);
  const auto column = [&](float i) { return wrapped(use.wrap_u, i, pixels.width); };
  const auto row = [&](float i) { return wrapped(use.wrap_v, i, pixels.height); };
  if (use.filter == Filter::nearest) return texel(pixels, column(std::floor(x)), row(std::floor(y)), colour);
  const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
  const float s = x - 0.5f - left, t = y - 0.5f - top;
  const int x0 = column(left), x1 = column(left + 1), y0 = row(top), y1 = row(top + 1);
  const Vec4 upper = texel(pixels, x0, y0, colour) * (1 - s) + texel(pixels, x1, y0, colour) * s;
  const Vec4 lower = texel(pixels, x0, y1, colour) * (1 - s) + texel(pixels, x1, y1, colour) * s;
  return upper * (1 - t) + lower * t;
}

}  // namespace

Vec4 look_up(const TextureImage& image, const Texture& use, Vec2 uv, bool colour) {
  uv = transformed(use, uv);
  if (!(std::abs(uv.x) < kFarthest && std::abs(uv.y) < kFarthest)) uv = Vec2(0);
  return std::visit(
      [&](const auto& pixels) { return pixels.pixels.empty() ? Vec4(1) : filtered(pixels, use, uv, colour); },
      image.pixels);
}

}  // namespace aktina
