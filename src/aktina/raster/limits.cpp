#include "aktina/raster/limits.h"

#include <fmt/core.h>

#include "aktina/base/error.h"
#include "aktina/image/file_format.h"

namespace aktina {

void check_picture(const Camera& camera, int width, int height) {
  if (width < 1 || height < 1 || width > kMostSide || height > kMostSide ||
      uint64_t(width) * uint64_t(height) > kMostPixels)
    throw Error(Code::limit, "raster.size", fmt::format("got {} x {} px", width, height),
                fmt::format("at least 1 x 1, sides up to {}, {} pixels in all", kMostSide, kMostPixels));
  const bool near_enough = camera.kind == Camera::Kind::orthographic || camera.near > 0;
  if (!near_enough || !(camera.far > camera.near))
    throw Error(Code::bad_param, "camera.near", fmt::format("got {} m, far {} m", camera.near, camera.far),
                "above 0 in perspective, and nearer than far");
}

}  // namespace aktina
