// The parts of compare(). Pictures are linear RGB of the same size, without NaN or infinities.
#pragma once

#include <span>

#include "aktina/image/metric.h"

namespace aktina {

/// Sets rmse, psnr, max_error and relative_mse.
/// @param peak  of the signal, for the PSNR; 0: the largest value of the reference
void compare_values(const Image& picture, const Image& reference, double peak, ImageComparison& result);

/// Mean structural similarity of two pictures of one channel.
/// @param top  the largest value that the channel can have
double structural_similarity(const Image& picture, const Image& reference, double top);

/// Convolution with a kernel that is a product of one along x and one along y, each of odd length; the border's values
/// go on outside. One channel.
Image filter_separable(const Image& image, std::span<const float> along_x, std::span<const float> along_y);

/// exp(-x^2 / (2 sigma^2)) for x = -radius .. radius, with sum 1.
std::vector<float> gaussian_kernel(double sigma, int radius);

}  // namespace aktina
