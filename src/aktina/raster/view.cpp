#include "aktina/raster/view.h"

#include <algorithm>
#include <cmath>

namespace aktina {

View::View(const Camera& camera, int width, int height)
    : width_(width),
      height_(height),
      clip_from_world_(aktina::clip_from_world(camera, width, height)),
      near_(camera.near),
      far_(camera.far) {
  const bool perspective = camera.kind == Camera::Kind::perspective;
  eye_ = camera.position();
  forward_ = camera.forward();
  viewer_ = perspective ? Viewer{eye_, false} : Viewer{-forward_, true};
  for (int k = 0; k < 3; ++k) clip_from_world_[k].z = forward_[k];
  clip_from_world_[3].z = -dot(eye_, forward_);
  const auto across = [&](float x, float y) {
    const CameraRay ray = camera_ray(camera, x, y, width, height);
    return perspective ? ray.direction / dot(ray.direction, forward_) : ray.origin - eye_;
  };
  corner_ = across(0, 0);
  right_ = (across(float(width), 0) - corner_) / float(width);
  down_ = (across(0, float(height)) - corner_) / float(height);
}

ScreenVertex View::project(Vec4 clip) const {
  const float weight = 1 / clip.w;
  const auto banded = [](float v) { return std::clamp(v, -kGuardBand, kGuardBand); };  // cut points are rounded
  const float x = banded((clip.x * weight * 0.5f + 0.5f) * float(width_));
  const float y = banded((0.5f - clip.y * weight * 0.5f) * float(height_));
  return {int32_t(std::lrint(x * kSubpixels)), int32_t(std::lrint(y * kSubpixels)), perspective() ? weight : -clip.z,
          weight};
}

}  // namespace aktina
