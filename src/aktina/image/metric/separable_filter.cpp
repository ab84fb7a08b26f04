#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/image/metric/metrics.h"

namespace aktina {
namespace {

constexpr size_t kBlock = 16;  // sums that stay in registers
constexpr size_t kRows = 8;    // of one task

/// out[x] = sum of weights[k] * sources[k][x]: both passes are this, with other sources.
void weighted_sum(std::span<const float* const> sources, std::span<const float> weights, std::span<float> out) {
  size_t x = 0;
  for (; x + kBlock <= out.size(); x += kBlock) {
    float sums[kBlock] = {};
    for (size_t k = 0; k < weights.size(); ++k)
      for (size_t i = 0; i < kBlock; ++i) sums[i] += weights[k] * sources[k][x + i];
    std::copy_n(sums, kBlock, &out[x]);
  }
  for (; x < out.size(); ++x) {
    float sum = 0;
    for (size_t k = 0; k < weights.size(); ++k) sum += weights[k] * sources[k][x];
    out[x] = sum;
  }
}

Image filter_rows(const Image& image, std::span<const float> kernel) {
  Image out(image.width, image.height, 1);
  const size_t width = size_t(image.width), radius = kernel.size() / 2;
  parallel_for(size_t(image.height), kRows, [&](size_t begin, size_t end) {
    std::vector<float> padded(width + 2 * radius);
    std::vector<const float*> sources;
    for (size_t k = 0; k < kernel.size(); ++k) sources.push_back(padded.data() + k);
    for (size_t y = begin; y < end; ++y) {
      const float* const row = image.at(0, int(y));
      std::fill_n(padded.begin(), radius, row[0]);
      std::copy_n(row, width, padded.begin() + std::ptrdiff_t(radius));
      std::fill_n(padded.end() - std::ptrdiff_t(radius), radius, row[width - 1]);
      weighted_sum(sources, kernel, {out.at(0, int(y)), width});
    }
  });
  return out;
}

Image filter_columns(const Image& image, std::span<const float> kernel) {
  Image out(image.width, image.height, 1);
  const int radius = int(kernel.size() / 2);
  parallel_for(size_t(image.height), kRows, [&](size_t begin, size_t end) {
    std::vector<const float*> sources(kernel.size());
    for (int y = int(begin); y < int(end); ++y) {
      for (size_t k = 0; k < kernel.size(); ++k)
        sources[k] = image.at(0, std::clamp(y + int(k) - radius, 0, image.height - 1));
      weighted_sum(sources, kernel, {out.at(0, y), size_t(image.width)});
    }
  });
  return out;
}

}  // namespace

Image filter_separable(const Image& image, std::span<const float> along_x, std::span<const float> along_y) {
  return filter_columns(filter_rows(image, along_x), along_y);
}

std::vector<float> gaussian_kernel(double sigma, int radius) {
  std::vector<double> exact;
  double sum = 0;
  for (int x = -radius; x <= radius; ++x) sum += exact.emplace_back(std::exp(-0.5 * x * x / (sigma * sigma)));
  std::vector<float> kernel;
  for (const double value : exact) kernel.push_back(float(value / sum));
  return kernel;
}

}  // namespace aktina
