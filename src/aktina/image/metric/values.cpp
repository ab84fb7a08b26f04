// Differences value by value: RMSE, PSNR, the largest one, and the relative mean squared error.
#include <algorithm>
#include <cmath>
#include <limits>

#include "aktina/base/parallel.h"
#include "aktina/image/metric/metrics.h"

namespace aktina {
namespace {

struct Sums {
  double squared = 0, relative = 0, largest = 0, peak = 0;
};

Sums of_row(std::span<const float> a, std::span<const float> b) {
  Sums sums;
  for (size_t i = 0; i < a.size(); ++i) {
    const double difference = double(a[i]) - b[i], squared = difference * difference;
    sums.squared += squared;
    sums.relative += squared / (double(b[i]) * b[i] + 0.01);
    sums.largest = std::max(sums.largest, std::abs(difference));
    sums.peak = std::max(sums.peak, double(b[i]));
  }
  return sums;
}

}  // namespace

void compare_values(const Image& picture, const Image& reference, double peak, ImageComparison& result) {
  const size_t row = size_t(picture.width) * size_t(picture.channels);
  std::vector<Sums> rows(size_t(picture.height));  // added up in order: the same sum for any number of threads
  parallel_for(rows.size(), 16, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) rows[y] = of_row({picture.at(0, int(y)), row}, {reference.at(0, int(y)), row});
  });
  Sums all;
  for (const Sums& sums : rows) {
    all.squared += sums.squared, all.relative += sums.relative;
    all.largest = std::max(all.largest, sums.largest), all.peak = std::max(all.peak, sums.peak);
  }
  const auto count = double(picture.pixels.size());
  result.rmse = std::sqrt(all.squared / count);
  result.relative_mse = all.relative / count;
  result.max_error = all.largest;
  result.psnr = result.rmse > 0 ? 20 * std::log10((peak > 0 ? peak : all.peak) / result.rmse)
                                : std::numeric_limits<double>::infinity();
}

}  // namespace aktina
