// Pictures put together from channels of others, where formats keep apart what a material here has in one picture.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "aktina/import/beside.h"

namespace aktina {
namespace {

/// One channel of the new picture: of another picture, or the same everywhere.
struct Channel {
  const TextureImage* from = nullptr;
  int index = 0;  // of RGBA
  uint8_t value = 255;
};

/// Texel (x, y) of a picture of another size: the one at the same place, as it is stored.
uint8_t texel(const Channel& channel, int x, int y, int width, int height) {
  if (channel.from == nullptr) return channel.value;
  const Vec2 uv((float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height));
  const Vec4 found = look_up(*channel.from, {.image = 0}, uv, false);
  return uint8_t(std::lround(std::clamp(found[channel.index], 0.0f, 1.0f) * 255));
}

/// As large as the largest.
Bitmap combined(const std::array<Channel, 4>& channels) {
  Bitmap out;
  for (const Channel& channel : channels)
    if (channel.from != nullptr)
      out.width = std::max(out.width, channel.from->width()), out.height = std::max(out.height, channel.from->height());
  out.pixels.reserve(size_t(out.width) * size_t(out.height) * 4);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      for (const Channel& channel : channels) out.pixels.push_back(texel(channel, x, y, out.width, out.height));
  return out;
}

/// Whether a picture's own alpha says something.
bool has_alpha(const TextureImage& image) {
  const auto* bitmap = std::get_if<Bitmap>(&image.pixels);
  if (bitmap == nullptr) return false;
  for (size_t i = 3; i < bitmap->pixels.size(); i += 4)
    if (bitmap->pixels[i] != 255) return true;
  return false;
}

}  // namespace

int Beside::with_alpha(Scene& scene, int colour, int opacity) {
  const auto [known, fresh] = images_.try_emplace(fmt::format("alpha\n{} {}", colour, opacity), -1);
  if (!fresh) return known->second;
  const auto* base = colour < 0 ? nullptr : &scene.images[size_t(colour)];
  const auto* cover = &scene.images[size_t(opacity)];
  TextureImage image;
  image.name = base != nullptr ? base->name : cover->name;
  image.pixels = combined({Channel{base, 0}, {base, 1}, {base, 2}, {cover, has_alpha(*cover) ? 3 : 0}});
  scene.images.push_back(std::move(image));
  return known->second = int(scene.images.size()) - 1;
}

int Beside::metallic_roughness(Scene& scene, int metallic, int roughness) {
  const auto [known, fresh] = images_.try_emplace(fmt::format("metal\n{} {}", metallic, roughness), -1);
  if (!fresh) return known->second;
  const auto source = [&](int index) { return index < 0 ? nullptr : &scene.images[size_t(index)]; };
  TextureImage image;
  image.name = source(std::max(metallic, roughness))->name;
  image.pixels = combined({Channel{}, {source(roughness), 0}, {source(metallic), 0}, {}});
  scene.images.push_back(std::move(image));
  return known->second = int(scene.images.size()) - 1;
}

}  // namespace aktina
