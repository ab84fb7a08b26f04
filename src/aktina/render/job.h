// Jobs: a scene and a choice of methods -> a result and a report. What the program, the Python module and the studio
// call; nothing else does the same a second way.
#pragma once

#include <functional>
#include <string>

#include "aktina/illumination/illuminate.h"
#include "aktina/image/image.h"
#include "aktina/radiosity/solve.h"
#include "aktina/render/report.h"
#include "aktina/scene/scene.h"

namespace aktina {

struct RenderOptions {
  /// "raster"; an integrator ("whitted", "direct", "path"); "radiosity" or "two_pass". With parameters after a colon.
  std::string method = "path";
  std::string shading = "phong", illumination = "phong";  // raster
  RadiosityOptions radiosity{};                           // radiosity, two_pass
  int width = 0, height = 0;                              // px; 0: from the camera's aspect, 960 px wide
  DepthCue depth_cue{};                                   // raster, whitted: k1 and k2
  int samples = 0;                                        // per pixel; 0: the method's own default
  int camera = 0;                                         // index into Scene::cameras
  const Camera* view = nullptr;                           // a camera of the caller's own instead
  uint32_t seed = 0;
  std::vector<std::string> layers{};  // "albedo", "N", "P", "Z", "direct", "indirect", "illuminance"
  std::function<void(const LayeredImage& picture)> each_pass{};
};

/// What RenderOptions::method can be.
std::vector<std::string_view> render_methods();

struct Rendering {
  LayeredImage picture;
  Report report;
};

/// @throws Error usage, bad_param, no_such_method, limit, cancelled (nothing worth keeping yet). A run that is
/// cancelled later returns what it has, with report.complete = false.
Rendering render(const Scene& scene, const RenderOptions& options, Progress& progress);

struct Radiosities {
  Solution solution;
  Report report;
};
Radiosities solve(const Scene& scene, const RadiosityOptions& options, Progress& progress);

struct LightRadiosities {
  std::string light;  // its name
  Radiosities result;
};
/// Each light by itself: solve_each_light().
std::vector<LightRadiosities> solve_lights(const Scene& scene, const RadiosityOptions& options, Progress& progress);
struct DimmedLight {
  std::string light;
  const Radiosities* result;
  double factor;
};
/// Those of one run together, each times its factor: mixed(). @throws Error usage, bad_param
Radiosities mix(std::span<const DimmedLight> lights);

/// A solution as a file: .aktina (to be loaded again), .vtu (ParaView), .csv (a line a patch), .glb or .gltf (the lit
/// model), by the extension. @throws Error usage (another extension), io
void write_radiosities(const Path& path, const Scene& scene, const Radiosities& radiosities);

}  // namespace aktina
