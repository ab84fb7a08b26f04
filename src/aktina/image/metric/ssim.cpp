// Structural similarity: luminance, contrast and structure of two pictures compared in a window that moves over them.
//
// Z. Wang, A. Bovik, H. Sheikh, E. Simoncelli, "Image Quality Assessment: From Error Visibility to Structural
// Similarity", IEEE Trans. Image Processing 13(4), 2004: Gaussian window of 11 x 11 with sigma 1.5, K1 0.01, K2 0.03.
#include <algorithm>

#include "aktina/image/metric/metrics.h"

namespace aktina {
namespace {

constexpr int kRadius = 5;

Image product(const Image& a, const Image& b) {
  Image out(a.width, a.height, 1);
  std::transform(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), out.pixels.begin(), std::multiplies<>());
  return out;
}

}  // namespace

double structural_similarity(const Image& a, const Image& b, double top) {
  const std::vector<float> window = gaussian_kernel(1.5, kRadius);
  const auto mean = [&](const Image& image) { return filter_separable(image, window, window); };
  const Image mean_a = mean(a), mean_b = mean(b);
  const Image mean_aa = mean(product(a, a)), mean_bb = mean(product(b, b)), mean_ab = mean(product(a, b));
  const double c1 = 0.01 * top * 0.01 * top, c2 = 0.03 * top * 0.03 * top;

  // Windows that lie in the picture; of a picture that is too small for one, all.
  const int x0 = a.width > 2 * kRadius ? kRadius : 0, y0 = a.height > 2 * kRadius ? kRadius : 0;
  double sum = 0;
  for (int y = y0; y < a.height - y0; ++y) {
    for (int x = x0; x < a.width - x0; ++x) {
      const double ma = *mean_a.at(x, y), mb = *mean_b.at(x, y);
      const double variance_a = *mean_aa.at(x, y) - ma * ma, variance_b = *mean_bb.at(x, y) - mb * mb;
      const double covariance = *mean_ab.at(x, y) - ma * mb;
      sum += (2 * ma * mb + c1) * (2 * covariance + c2) / ((ma * ma + mb * mb + c1) * (variance_a + variance_b + c2));
    }
  }
  return sum / (double(a.width - 2 * x0) * double(a.height - 2 * y0));
}

}  // namespace aktina
