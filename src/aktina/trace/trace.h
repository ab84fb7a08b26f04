// A scene and a camera -> a picture, by rays: the front of all integrators.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "aktina/base/progress.h"
#include "aktina/illumination/illuminate.h"
#include "aktina/image/image.h"
#include "aktina/scene/scene.h"

namespace aktina {

struct TraceOptions {
  std::string integrator = "path";  // "METHOD" or "METHOD:parameter=number,...", as integrators() lists them
  std::string accelerator{};        // as accelerators() lists them; empty: the fastest one for the scene
  int samples = 16;                 // per pixel
  uint32_t seed = 0;
  DepthCue depth_cue{};  // of "whitted"; trace() takes eye and forward from the camera
  // Layers beside the picture: "albedo" (base colour), "N" (unit shading normal, world), "P" (m, world), "Z" (distance
  // along the view axis, m; infinite where nothing is seen), "direct" and "indirect" (cd/m^2; their sum is the
  // picture), "illuminance" (lx, arriving at what the camera sees).
  bool albedo = false, normal = false, position = false, depth = false;
  bool direct = false, indirect = false, illuminance = false;
  /// Called after each progressive pass with the picture so far, and how many samples a pixel it has.
  std::function<void(const LayeredImage& picture, int samples)> each_pass{};
};

struct TraceStatistics {
  int samples = 0;  // per pixel, taken; fewer than asked for where the work was cancelled
  uint64_t rays = 0, shadow_rays = 0;
  uint64_t not_finite = 0;  // samples dropped because they were NaN or infinite: a fault, counted and not hidden
  double build_seconds = 0, trace_seconds = 0;
};

/// Linear radiance, cd/m^2. Samples come in passes over the whole picture, so that a cancelled run leaves a picture
/// with fewer samples: what is done when `progress` is cancelled is returned, and statistics say how much it is. The
/// same bytes for any number of threads.
/// @throws Error usage, bad_param, no_such_method (options), limit (size); cancelled (before the first pass is done)
LayeredImage trace(const Scene& scene, const Camera& camera, int width, int height, const TraceOptions& options = {},
                   Progress* progress = nullptr, TraceStatistics* statistics = nullptr);

}  // namespace aktina
