// Cameras as dictionaries: {"position": ..., "target": ..., "up": ..., "vertical_fov": ...}.
#pragma once

#include <fmt/core.h>

#include "aktina/scene/camera.h"
#include "fields.h"

namespace aktina::python {

/// "half_height" (m) in place of "vertical_fov" makes a parallel projection.
/// @throws Error usage (an unknown key), bad_param (no view)
inline Camera camera_from(const py::dict& dict) {
  Vec3 position(0, 0, 5), target(0), up(0, 1, 0);
  float fov = 0.7f, half_height = 0;
  FromDict reader(dict, "camera");
  reader("position", position), reader("target", target), reader("up", up), reader("vertical_fov", fov);
  reader("half_height", half_height);
  reader.expect_all_read();
  if (!(length(cross(target - position, up)) > 0))
    throw Error(Code::bad_param, "camera", "position, target and up do not span a view");
  if (!(fov > 0 && fov < 3.14f) || half_height < 0)
    throw Error(Code::bad_param, "camera.vertical_fov", fmt::format("got {}", fov), "accepted above 0 .. 3.14 rad");
  Camera camera = look_at(position, target, up, fov);
  if (half_height > 0) camera.kind = Camera::Kind::orthographic, camera.half_height = half_height;
  return camera;
}

inline py::dict camera_dict(const Camera& camera) {
  ToDict writer;
  const Vec3 position = camera.position();
  writer("position", position), writer("target", position + camera.forward());
  writer("up", Vec3(camera.to_world[1]));
  if (camera.kind == Camera::Kind::orthographic)
    writer("half_height", camera.half_height);
  else
    writer("vertical_fov", camera.vertical_fov);
  return writer.dict();
}

}  // namespace aktina::python
