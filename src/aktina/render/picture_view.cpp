#include "aktina/render/picture_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"

namespace aktina {
namespace {

constexpr int kLargestSide = 1 << 16;
constexpr uint64_t kMostPicturePixels = uint64_t(1) << 27;  // 1.6 GB a layer of three channels
constexpr float kAspect = 1.5f;                             // of a camera that leaves it open

}  // namespace

const Camera& chosen_camera(const Scene& scene, int index) {
  if (scene.cameras.empty()) throw Error(Code::usage, "camera", "the scene has none");
  if (index < 0 || size_t(index) >= scene.cameras.size())
    throw Error(Code::usage, "camera", fmt::format("there is no camera {}", index),
                fmt::format("the scene has cameras 0 .. {}", scene.cameras.size() - 1));
  return scene.cameras[size_t(index)];
}

void fill_size(const Camera& camera, int default_width, int& width, int& height) {
  const double aspect = double(camera.aspect > 0 ? camera.aspect : kAspect);
  if (width == 0) width = height == 0 ? default_width : int(std::lround(std::clamp(height * aspect, 1.0, 1e9)));
  if (height == 0) height = int(std::lround(std::clamp(width / aspect, 1.0, 1e9)));
  if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide ||
      uint64_t(width) * uint64_t(height) > kMostPicturePixels)
    throw Error(Code::limit, "size", fmt::format("got {} x {} px", width, height),
                fmt::format("at least 1 x 1, sides up to {}, {} pixels in all", kLargestSide, kMostPicturePixels));
}

}  // namespace aktina
