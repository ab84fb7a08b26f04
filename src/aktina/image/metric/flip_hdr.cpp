// HDR-FLIP: the largest FLIP error over the exposures at which a viewer might look at the picture, from the one that
// shows the brightest pixel to the one that shows the median pixel.
//
// P. Andersson, J. Nilsson, P. Shirley, T. Akenine-Moller, "Visualizing Errors in Rendered High Dynamic Range Images",
// Eurographics 2021 Short Papers.
#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/image/metric.h"

namespace aktina {
namespace {

/// The fit to the ACES curve (Narkowicz 2016) with its exposure factor of 0.6 folded in, as the paper has it:
/// (a x^2 + b x) / (c x^2 + d x + e).
struct Curve {
  double a = 0.6 * 0.6 * 2.51, b = 0.6 * 0.03, c = 0.6 * 0.6 * 2.43, d = 0.6 * 0.59, e = 0.14;

  float operator()(float x) const {
    x = std::clamp(x, 0.0f, 1e6f);
    const float y = (float(a) * x + float(b)) * x / ((float(c) * x + float(d)) * x + float(e));
    return std::min(y, 1.0f);
  }
  /// Where the curve has the value t: the larger root of (a - c t) x^2 + (b - d t) x - e t = 0.
  double inverse(double t) const {
    const double qa = a - c * t, qb = b - d * t, qc = -e * t;
    return (-qb + std::sqrt(qb * qb - 4 * qa * qc)) / (2 * qa);
  }
};

constexpr double kShown = 0.85;  // the tone-mapped value that counts as shown
constexpr int kMostExposures = 32;

struct Exposures {
  double first = 0, last = 0;  // log2
  int count = 1;
};

/// From the reference alone. Black pixels count for the median only if there is nothing else.
Exposures exposures(const Image& reference) {
  std::vector<float> lit;
  for (int y = 0; y < reference.height; ++y)
    for (int x = 0; x < reference.width; ++x)
      if (const float l = luminance(reference.rgb(x, y)); l > 0 && std::isfinite(l)) lit.push_back(l);
  if (lit.empty()) return {};
  const auto middle = lit.begin() + std::ptrdiff_t(lit.size() / 2);
  std::nth_element(lit.begin(), middle, lit.end());
  const double shown = Curve().inverse(kShown), median = *middle, brightest = *std::max_element(lit.begin(), lit.end());
  Exposures range{std::log2(shown / brightest), std::log2(shown / median), 2};
  range.count = std::clamp(int(std::ceil(range.last - range.first)), 2, kMostExposures);
  return range;
}

Image exposed(const Image& picture, float factor) {
  Image out(picture.width, picture.height, 3);
  const Curve curve;
  parallel_for(size_t(picture.height), 16, [&](size_t begin, size_t end) {
    for (int y = int(begin); y < int(end); ++y)
      for (int x = 0; x < picture.width; ++x) {
        const Rgb c = picture.rgb(x, y) * factor;
        out.set_rgb(x, y, {curve(c.r), curve(c.g), curve(c.b)});
      }
  });
  return out;
}

}  // namespace

Image flip_map_hdr(const Image& picture, const Image& reference, double pixels_per_degree) {
  const Exposures range = exposures(reference);
  Image largest;
  for (int i = 0; i < range.count; ++i) {
    const double step = range.count > 1 ? double(i) / (range.count - 1) : 0;
    const auto factor = float(std::exp2(range.first + step * (range.last - range.first)));
    Image map = flip_map(exposed(picture, factor), exposed(reference, factor), pixels_per_degree);
    if (largest.empty())
      largest = std::move(map);
    else
      std::transform(map.pixels.begin(), map.pixels.end(), largest.pixels.begin(), largest.pixels.begin(),
                     [](float a, float b) { return std::max(a, b); });
  }
  return largest;
}

}  // namespace aktina
