// The illumination equation at many points at a time: a material, a model and all lights, resolved once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aktina/illumination/illuminate.h"
#include "aktina/illumination/lamp.h"

namespace aktina {

/// Arrays of the SIMD code are aligned to 64 bytes and padded to a multiple of kLanes values.
inline constexpr size_t kLanes = 16;
inline constexpr size_t padded(size_t n) { return (n + kLanes - 1) / kLanes * kLanes; }

/// Coefficients that differ from point to point, as textures have them.
struct SurfaceArrays {
  const float* ka[3];
  const float* kd[3];
  const float* ks[3];
  const float* exponent;
  const Surface* whole = nullptr;  // one a point, unpadded: for models that read more (reads_whole_surface)
};

/// Structure of arrays: `count` points, each array 64-byte aligned and padded.
struct PointArrays {
  size_t count;
  const float* position[3];                // m, world
  const float* normal[3];                  // of any length above 1e-15; on the side that is seen
  const SurfaceArrays* surface = nullptr;  // null: the material's own coefficients everywhere
  bool unit_normals = false;               // of length 1, or near enough: not made unit again
};

/// Where radiance goes, cd/m^2; arrays as above, padding is written too.
struct LitArrays {
  float* diffuse[3];  // with ambient light
  float* specular[3];
};

/// Points that this thread has had lit by Illuminator::evaluate so far: what a study counts as evaluations of the
/// model.
uint64_t points_lit_by_this_thread();

class Illuminator {
 public:
  Illuminator(const IlluminationModel& model, const Surface& surface, std::span<const Light> lights, Rgb ambient,
              const Viewer& viewer);

  /// illuminate() at each point, by SIMD; relative error about 1e-5, and finite for finite points.
  void evaluate(const PointArrays& points, const LitArrays& out) const;

  /// Whether the model reads more than ka, kd, ks and the exponent: of textured points then SurfaceArrays::whole.
  bool reads_whole_surface() const;

  const IlluminationModel& model() const { return model_; }
  std::span<const Light> lights() const { return lights_; }
  const Surface& surface() const { return surface_; }
  const Viewer& viewer() const { return viewer_; }
  std::span<const Lamp> lamps() const { return lamps_; }
  Rgb ambient() const { return ambient_; }

 private:
  IlluminationModel model_;
  Surface surface_;
  std::vector<Light> lights_;
  std::vector<Lamp> lamps_;
  Rgb ambient_;
  Viewer viewer_;
};

}  // namespace aktina
