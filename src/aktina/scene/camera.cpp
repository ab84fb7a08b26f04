#include "aktina/scene/camera.h"

#include <cmath>

namespace aktina {
namespace {

/// Half extents of the picture at distance 1 (perspective) or anywhere (orthographic). A camera wider than its
/// picture keeps its vertical angle; the picture's own proportions decide the rest.
Vec2 half_extent(const Camera& camera, int width, int height) {
  const float aspect = float(width) / float(height);
  const float half_height =
      camera.kind == Camera::Kind::perspective ? std::tan(camera.vertical_fov / 2) : camera.half_height;
  return {half_height * aspect, half_height};
}

}  // namespace

CameraRay camera_ray(const Camera& camera, float x, float y, int width, int height) {
  const Vec2 half = half_extent(camera, width, height);
  const float u = (2 * x / float(width) - 1) * half.x, v = (1 - 2 * y / float(height)) * half.y;
  if (camera.kind == Camera::Kind::orthographic) return {transform_point(camera.to_world, {u, v, 0}), camera.forward()};
  return {camera.position(), normalize(transform_vector(camera.to_world, {u, v, -1}))};
}

Mat4 clip_from_world(const Camera& camera, int width, int height) {
  const Vec2 half = half_extent(camera, width, height);
  const float near = camera.near, far = camera.far;
  Mat4 projection(0);
  projection[0][0] = 1 / half.x;
  projection[1][1] = 1 / half.y;
  const bool infinite = !(far < kInfinity);
  if (camera.kind == Camera::Kind::perspective) {
    projection[2][2] = infinite ? -1 : -(far + near) / (far - near);
    projection[2][3] = -1;
    projection[3][2] = infinite ? -2 * near : -2 * far * near / (far - near);
  } else {
    const float depth = infinite ? 1e6f : far;
    projection[2][2] = -2 / (depth - near);
    projection[3][2] = -(depth + near) / (depth - near);
    projection[3][3] = 1;
  }
  return projection * glm::inverse(camera.to_world);
}

Camera look_at(Point3 eye, Point3 target, Vec3 up, float vertical_fov) {
  const Vec3 back = normalize_or(eye - target, {0, 0, 1});
  Vec3 right = cross(up, back);
  right = squared_length(right) > 1e-12f ? normalize(right) : Frame(back).t;
  Camera camera;
  camera.to_world = Mat4(Vec4(right, 0), Vec4(cross(back, right), 0), Vec4(back, 0), Vec4(eye, 1));
  camera.vertical_fov = vertical_fov;
  return camera;
}

Camera frame(const Bounds& bounds, float vertical_fov) {
  if (bounds.empty()) return look_at({0, 0, 3}, {0, 0, 0}, {0, 1, 0}, vertical_fov);
  const float radius = 0.5f * bounds.diagonal() > 0 ? 0.5f * bounds.diagonal() : 1;
  const Vec3 direction = normalize(Vec3(0.45f, 0.35f, 1));
  const float distance = radius / std::sin(vertical_fov / 2);
  Camera camera = look_at(bounds.centre() + direction * distance, bounds.centre(), {0, 1, 0}, vertical_fov);
  camera.name = "default";
  camera.near = distance * 1e-3f;
  return camera;
}

}  // namespace aktina
