// The ways of drawing a picture, one function each; job.cpp chooses.
#pragma once

#include "aktina/render/job.h"

namespace aktina {

/// What every way is given: the options, with their defaults filled in.
struct PictureJob {
  const Scene& scene;
  const RenderOptions& options;
  const Camera& camera;
  int width, height;
  Progress& progress;
  Report& report;

  int samples(int fallback) const { return options.samples > 0 ? options.samples : fallback; }
  bool wants(std::string_view layer) const;
};

// Each adds its timings and counts to the report, and marks it where the picture is not complete.
LayeredImage draw_by_raster(PictureJob& job);
LayeredImage draw_by_rays(PictureJob& job);  // any integrator
LayeredImage draw_by_radiosity(PictureJob& job);
LayeredImage draw_by_two_passes(PictureJob& job);

/// @throws Error usage where a layer is wanted that is not among `known`, which the method has
void check_layers(const PictureJob& job, std::span<const std::string_view> known);

}  // namespace aktina
