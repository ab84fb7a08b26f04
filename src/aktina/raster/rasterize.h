// A scene and a camera -> a picture: visible surfaces by depth buffer, light interpolated by a shading method.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "aktina/base/progress.h"
#include "aktina/illumination/illuminate.h"
#include "aktina/image/image.h"
#include "aktina/raster/item_buffer.h"
#include "aktina/scene/scene.h"

namespace aktina {

struct RasterOptions {
  std::string shading = "phong";       // "METHOD" or "METHOD:parameter=number,...", as shading_methods() lists them
  std::string illumination = "phong";  // as illumination_models() lists them
  int samples = 1;                     // per pixel: 1, 4 or 16 on a regular grid, averaged
  DepthCue depth_cue{};                // eye and forward follow the camera
  bool cull_back_faces = false;        // leave out the backs of single-sided materials; else both sides are drawn
  // PictureLayers beside the picture: "albedo" (base colour), "N" (unit shading normal, world), "P" (m, world), "Z"
  // (distance along the view axis, m; infinite where nothing is seen).
  bool albedo = false, normal = false, position = false, depth = false;
};

/// What a frame cost, its two halves apart.
struct FrameCost {
  double setup_seconds = 0;  // vertices projected and lit; triangles gathered, set up, sorted into bands
  double pixel_seconds = 0;  // bands: coverage, depth, shading of pixels, averaging of samples
  uint64_t triangles = 0;    // set up: what is in view, cut by clipping
  /// Evaluations of the illumination model in each half, with lanes that SIMD fills up; right on one thread only.
  uint64_t setup_evaluations = 0, pixel_evaluations = 0;
};

/// A scene made ready once, drawn from many views: draw() converts nothing, and keeps its memory for the next call.
class Rasterizer {
 public:
  /// The scene must outlive the rasterizer, unchanged but for its cameras.
  /// @throws Error as rasterize()
  Rasterizer(const Scene& scene, const RasterOptions& options);
  ~Rasterizer();
  Rasterizer(const Rasterizer&) = delete;
  Rasterizer& operator=(const Rasterizer&) = delete;

  /// As rasterize(); `out` is filled anew, in place where it has the right size already.
  void draw(const Camera& camera, int width, int height, LayeredImage& out, Progress* progress = nullptr);
  const FrameCost& last_frame() const;

 private:
  class Workshop;
  std::unique_ptr<Workshop> workshop_;
};

/// Linear radiance, cd/m^2, lit by lamps without shadows; emissive surfaces count as small lamps, and the sky as
/// ambient light. The same bytes for any number of threads.
/// @throws Error usage, bad_param, no_such_method (options), limit (size), cancelled
LayeredImage rasterize(const Scene& scene, const Camera& camera, int width, int height,
                       const RasterOptions& options = {}, Progress* progress = nullptr);

/// Radiance given at the vertices (a radiosity solution), interpolated over each triangle of a mesh in world space.
/// @param radiance  cd/m^2, one per vertex
Image rasterize_radiance(const Mesh& mesh, std::span<const Rgb> radiance, const Camera& camera, int width, int height,
                         int samples = 1);

/// Which triangle each pixel sees; for many views of a scene see ItemRasterizer.
ItemBuffer rasterize_items(const Scene& scene, const Camera& camera, int width, int height);

}  // namespace aktina
