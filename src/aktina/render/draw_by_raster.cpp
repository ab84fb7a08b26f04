#include "aktina/raster/rasterize.h"
#include "aktina/render/picture_job.h"

namespace aktina {

LayeredImage draw_by_raster(PictureJob& job) {
  constexpr std::string_view kLayers[] = {"albedo", "N", "P", "Z"};
  check_layers(job, kLayers);
  const RasterOptions options{.shading = job.options.shading,
                              .illumination = job.options.illumination,
                              .samples = job.samples(4),
                              .depth_cue = job.options.depth_cue,
                              .albedo = job.wants("albedo"),
                              .normal = job.wants("N"),
                              .position = job.wants("P"),
                              .depth = job.wants("Z")};
  Stopwatch watch;
  LayeredImage picture = rasterize(job.scene, job.camera, job.width, job.height, options, &job.progress);
  job.report.time("rasterize", watch.lap());
  job.report.count("samples", options.samples, "1/px");
  return picture;
}

}  // namespace aktina
