// A solution from a camera: the lit scene, drawn by the rasterizer with interpolated vertex colours.
#include "aktina/radiosity/solve.h"
#include "aktina/raster/rasterize.h"

namespace aktina {

LayeredImage render_solution(const Scene& scene, const Solution& solution, const Camera& camera, int width, int height,
                             int samples, Progress* progress) {
  RasterOptions options;
  options.shading = "flat";  // unlit: base texture times interpolated vertex colour, whatever the shading
  options.samples = samples;
  options.cull_back_faces = true;
  return rasterize(lit_scene(scene, solution), camera, width, height, options, progress);
}

}  // namespace aktina
