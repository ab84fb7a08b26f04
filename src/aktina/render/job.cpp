#include "aktina/render/job.h"

#include <fmt/format.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/render/catalogue.h"
#include "aktina/render/job_report.h"
#include "aktina/render/picture_job.h"
#include "aktina/render/picture_view.h"

namespace aktina {
namespace {

constexpr int kWidth = 960;  // px, where no size is given

struct Way {
  std::string_view method;
  LayeredImage (*draw)(PictureJob&);
};
constexpr Way kWays[] = {{"raster", draw_by_raster},
                         {"radiosity", draw_by_radiosity},
                         {"two_pass", draw_by_two_passes}};  // and every integrator: draw_by_rays

/// The command that repeats the picture.
std::string settings(const PictureJob& job) {
  const RenderOptions& o = job.options;
  const std::string id = parse_method(o.method).id;
  std::string line = fmt::format("render {} --method {}", job.report.scene_file, o.method);
  if (id == "raster") line += fmt::format(" --shading {} --illumination {}", o.shading, o.illumination);
  line += fmt::format(" --size {}x{} --seed {}", job.width, job.height, o.seed);
  if (id == "radiosity" || id == "two_pass") line += " " + settings(o.radiosity);
  if (o.depth_cue.active()) line += fmt::format(" --depth-cue {},{}", o.depth_cue.k1, o.depth_cue.k2);
  if (o.samples > 0) line += fmt::format(" --samples {}", o.samples);
  if (o.camera > 0) line += fmt::format(" --camera {}", o.camera);
  if (!o.layers.empty()) line += fmt::format(" --layers {}", fmt::join(o.layers, ","));
  return line;
}

LayeredImage draw(PictureJob& job) {
  const std::string id = parse_method(job.options.method).id;
  if (job.options.depth_cue.active() && (id == "radiosity" || id == "two_pass"))
    throw Error(Code::usage, "depth_cue", fmt::format("method {} has no depth cueing", id), "raster and whitted have");
  for (const Way& way : kWays)
    if (way.method == id) return way.draw(job);
  for (const MethodInfo* integrator : find_family("integrator").methods)
    if (integrator->id == id) return draw_by_rays(job);
  no_such_method("render", id, fmt::format("{}", fmt::join(render_methods(), ", ")));
}

}  // namespace

std::vector<std::string_view> render_methods() {
  std::vector<std::string_view> methods;
  for (const Way& way : kWays) methods.push_back(way.method);
  for (const MethodInfo* integrator : find_family("integrator").methods) methods.push_back(integrator->id);
  return methods;
}

bool PictureJob::wants(std::string_view layer) const {
  return std::find(options.layers.begin(), options.layers.end(), layer) != options.layers.end();
}

void check_layers(const PictureJob& job, std::span<const std::string_view> known) {
  for (const std::string& layer : job.options.layers)
    if (std::find(known.begin(), known.end(), layer) == known.end())
      throw Error(Code::usage, "layers", fmt::format("method {} has no layer '{}'", job.options.method, layer),
                  fmt::format("it has: {}", fmt::join(known, ", ")));
}

Rendering render(const Scene& scene, const RenderOptions& options, Progress& progress) {
  const Camera& camera = options.view ? *options.view : chosen_camera(scene, options.camera);
  int width = options.width, height = options.height;
  fill_size(camera, kWidth, width, height);
  Rendering result;
  result.report = begin_report(scene, options.seed);
  PictureJob job{scene, options, camera, width, height, progress, result.report};
  result.report.settings = settings(job);
  result.picture = draw(job);
  return result;
}

}  // namespace aktina
