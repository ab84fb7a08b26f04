// Pinhole cameras, glTF's conventions: looking along -z of their node, +y up.
#pragma once

#include <string>

#include "aktina/base/vec.h"

namespace aktina {

struct Camera {
  enum class Kind : uint8_t { perspective, orthographic };
  std::string name;
  Kind kind = Kind::perspective;
  Mat4 to_world{1};           // rigid: camera space -> world
  float vertical_fov = 0.7f;  // rad; perspective
  float half_height = 1;      // m; orthographic
  float aspect = 0;           // width / height of the picture; 0: the picture's own
  float near = 0.01f;         // m
  float far = kInfinity;      // m

  Point3 position() const { return Vec3(to_world[3]); }
  Vec3 forward() const { return -Vec3(to_world[2]); }
};

/// Ray through picture position (x, y) in pixels, (0, 0) the upper left corner of a width x height picture.
struct CameraRay {
  Point3 origin;
  Vec3 direction;  // unit
};
CameraRay camera_ray(const Camera& camera, float x, float y, int width, int height);

/// World -> clip space (OpenGL: -w <= x, y, z <= w), for a width x height picture. `near` > 0 is used as it stands.
Mat4 clip_from_world(const Camera& camera, int width, int height);

Camera look_at(Point3 eye, Point3 target, Vec3 up, float vertical_fov);

/// Frames the box from above one corner, as a person would stand: used where a file has no camera.
Camera frame(const Bounds& bounds, float vertical_fov = 0.7f);

}  // namespace aktina
