#include "aktina/trace/camera_rays.h"

namespace aktina {

CameraRays::CameraRays(const Camera& camera, int width, int height)
    : perspective_(camera.kind == Camera::Kind::perspective),
      eye_(camera.position()),
      forward_(normalize(camera.forward())),
      near_(camera.near > 0 ? camera.near : 0),
      far_(camera.far > near_ ? camera.far : kInfinity) {
  const auto across = [&](float x, float y) {
    const CameraRay ray = camera_ray(camera, x, y, width, height);
    return perspective_ ? ray.direction / dot(ray.direction, forward_) : ray.origin - eye_;
  };
  corner_ = across(0, 0);
  right_ = (across(float(width), 0) - corner_) / float(width);
  down_ = (across(0, float(height)) - corner_) / float(height);
}

}  // namespace aktina
