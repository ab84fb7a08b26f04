// How far two pictures are apart.
#pragma once

#include <cstdint>
#include <string>

#include "aktina/image/image.h"

namespace aktina {

struct ImageComparison {
  double rmse = 0;  // root of the mean squared difference over all channels
  double psnr = 0;  // dB: peak over RMSE; the peak is 1, of HDR the reference's largest value; infinity where equal
  double max_error = 0;                         // largest absolute difference
  double relative_mse = 0;                      // mean of (a - b)^2 / (b^2 + 0.01)
  double ssim = 1;                              // structural similarity of luminance (Wang et al. 2004), 1: equal
  double flip = 0;                              // mean FLIP (Andersson et al. 2020; HDR: 2021), 0: equal
  bool flip_hdr = false;                        // which of the two
  uint64_t non_finite_a = 0, non_finite_b = 0;  // values that are NaN or infinite, taken as 0
};

enum class DynamicRange { automatic, low, high };

/// @param picture, reference  linear RGB of the same size
/// @param range  low: clipped to [0, 1] and compared as a screen shows it; automatic: high if either exceeds 1
/// @throws Error usage if the sizes differ
ImageComparison compare(const Image& picture, const Image& reference, DynamicRange range = DynamicRange::automatic);

/// Per-pixel FLIP error in [0, 1], one channel. LDR: Andersson et al., "FLIP: A Difference Evaluator for Alternating
/// Images", HPG 2020. Inputs linear RGB in [0, 1].
/// @param pixels_per_degree  of visual angle; 67.02: a 0.7 m wide 3840 pixel screen seen from 0.7 m
Image flip_map(const Image& picture, const Image& reference, double pixels_per_degree = 67.0206);
/// HDR: Andersson et al., "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics 2021.
Image flip_map_hdr(const Image& picture, const Image& reference, double pixels_per_degree = 67.0206);

/// False colours for a map in [0, 1] (magma-like, dark to bright), linear RGB.
Image false_colour(const Image& map);

}  // namespace aktina
