#include <algorithm>
#include <cmath>

#include "aktina/scene/scene.h"

namespace aktina {

Radiance radiance(const EnvironmentLight& light, Vec3 direction) {
  if (light.radiance.empty()) return light.colour;
  const Image& image = light.radiance;
  const float length2 = dot(direction, direction);
  const float y = length2 > 0 ? direction.y / std::sqrt(length2) : 1;
  const float u = (std::atan2(direction.x, -direction.z) + light.rotation) * float(0.5 / kPi) + 0.5f;
  const float v = std::acos(std::clamp(y, -1.0f, 1.0f)) * float(kInvPi);
  const float column = (u - std::floor(u)) * float(image.width) - 0.5f, row = v * float(image.height) - 0.5f;
  const float left = std::floor(column), top = std::floor(row);
  const float s = column - left, t = row - top;
  const auto wrap = [&](float x) { return (int(x) + image.width) % image.width; };
  const auto clamp = [&](float y_) { return std::clamp(int(y_), 0, image.height - 1); };
  const int x0 = wrap(left), x1 = wrap(left + 1), y0 = clamp(top), y1 = clamp(top + 1);
  const Rgb upper = image.rgb(x0, y0) * (1 - s) + image.rgb(x1, y0) * s;
  const Rgb lower = image.rgb(x0, y1) * (1 - s) + image.rgb(x1, y1) * s;
  return Radiance((upper * (1 - t) + lower * t) * light.colour.v);
}

}  // namespace aktina
