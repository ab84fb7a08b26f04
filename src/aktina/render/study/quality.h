// How far a picture is from the reference, as numbers.
#pragma once

#include <span>

#include "aktina/raster/item_buffer.h"
#include "aktina/render/study/study.h"

namespace aktina {

/// Values times `exposure`; what is not finite becomes 0.
Image exposed(const Image& picture, float exposure);

/// rmse, max_error, psnr, flip, not_finite. @param picture, reference  linear, cd/m^2
Quality compare_pictures(const Image& picture, const Image& reference, float exposure);

/// Pixels where a highlight adds more than a twentieth of white: 1, else 0. One channel.
/// @param shiny, matt  the same view with and without specular light, cd/m^2
Image highlight_mask(const Image& shiny, const Image& matt, float exposure);

/// Root of the mean squared difference where the mask is 1; unknown where it is nowhere.
double masked_rmse(const Image& picture, const Image& reference, const Image& mask, float exposure);

/// Places where two triangles of a smooth surface meet between neighbouring pixels, with three pixels on either side.
class SmoothEdges {
 public:
  /// @param scene  without primitives (TessellatedScene), as the item buffer has it
  SmoothEdges(const Scene& scene, const Camera& camera, int width, int height);

  size_t size() const { return places_.size(); }
  uint64_t covered_pixels() const { return covered_; }

  /// edge_jump: root of the mean square of the difference between the luminances at the edge, mach_band: the same of
  /// the derivatives, per pixel; each from the parabola through the pixels on its own side, so that a smooth picture
  /// has neither up to third order.
  /// @param picture  of the same view, one sample a pixel, cd/m^2
  void measure(const Image& picture, float exposure, Quality& out) const;

 private:
  struct Place {
    size_t first;  // pixel
    size_t step;   // to the next: 1 along x, the width along y
  };
  std::vector<Place> places_;
  uint64_t covered_ = 0;
};

/// The camera turned about the vertical through `centre`. @param angle  rad
Camera turned(const Camera& camera, Point3 centre, float angle);

/// Root of the mean square of the error's change between successive frames, in luminance.
/// @param pictures, references  the same views, cd/m^2
double flicker(std::span<const Image> pictures, std::span<const Image> references, float exposure);

}  // namespace aktina
