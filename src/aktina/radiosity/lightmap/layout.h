// Where everything stands on the pages of a lightmap.
#pragma once

#include <vector>

#include "aktina/base/warnings.h"
#include "aktina/radiosity/lightmap/chart.h"

namespace aktina {

struct LightmapOptions {
  double texel_size = 0;    // m; 0: the smallest at which all fits on one page
  int size = 1024;          // texels, largest width and height of a page
  int padding = 2;          // texels around each chart that belong to nobody else
  bool keep_uv = true;      // second texture coordinates of the file, where they can be used
  int direct_samples = 16;  // shadow rays a texel; 0: direct light as the solution has it
  int gather_samples = 0;   // rays a texel that gather indirect light; 0: as the solution has it
  uint32_t seed = 0;
};

struct PlacedChart {
  uint32_t surface = 0;
  int page = 0;
  int x = 0, y = 0, width = 0, height = 0;  // texels that it may touch
  std::vector<uint32_t> triangles;          // of the surface
  std::vector<FlatTriangle> texels;         // their corners; x to the right, y down, 0 at the page's upper left corner
};

struct LightmapLayout {
  struct Page {
    int width, height;
  };
  std::vector<Page> pages;
  std::vector<LightmapSurface> surfaces;
  std::vector<PlacedChart> charts;
  double texel_size = 0;  // m
  uint64_t kept = 0;      // surfaces whose own coordinates are used
  Warnings warnings;      // whose are not, and why
};

/// Middles of texels lie on the edges of the rectangle around a chart, so that what a viewer reads along straight edges
/// is what was computed there. Coordinates of a file are kept as they are where all surfaces share one page without
/// overlap; else each surface's are moved as a whole.
/// @throws Error bad_param, limit (what does not fit, and what would)
LightmapLayout make_layout(std::vector<LightmapSurface> surfaces, const LightmapOptions& options);

}  // namespace aktina
