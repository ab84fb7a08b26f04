// Rays of a camera, cheaply: what camera_ray() gives, without its trigonometry at each ray.
#pragma once

#include "aktina/scene/camera.h"
#include "aktina/trace/ray.h"

namespace aktina {

class CameraRays {
 public:
  CameraRays(const Camera& camera, int width, int height);
  /// Through picture position (x, y), px, from the camera's near to its far plane.
  Ray at(float x, float y) const {
    const Vec3 across = corner_ + x * right_ + y * down_;
    if (!perspective_) return {eye_ + across, forward_, near_, far_};
    const float inverse = 1 / length(across), slant = dot(across, forward_) * inverse;
    return {eye_, across * inverse, near_ / slant, far_ / slant};
  }
  /// Distance of a point along the view axis, m.
  float depth(Point3 p) const { return dot(p - eye_, forward_); }

 private:
  bool perspective_;
  Point3 eye_;
  Vec3 forward_;
  float near_, far_;
  Vec3 corner_, right_, down_;  // of the picture at distance 1; orthographic: around the eye
};

}  // namespace aktina
