#include "aktina/trace/environment_sampler.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"

namespace aktina {
namespace {

constexpr size_t kMostColumns = 1024;

/// Mean luminance of the texels of a cell.
float cell_luminance(const Image& image, size_t column, size_t row, size_t columns, size_t rows) {
  const auto width = size_t(image.width), height = size_t(image.height);
  const size_t x0 = column * width / columns, x1 = std::max((column + 1) * width / columns, x0 + 1);
  const size_t y0 = row * height / rows, y1 = std::max((row + 1) * height / rows, y0 + 1);
  double sum = 0;
  for (size_t y = y0; y < y1; ++y)
    for (size_t x = x0; x < x1; ++x) sum += double(std::max(luminance(image.rgb(int(x), int(y))), 0.0f));
  const double mean = sum / double((x1 - x0) * (y1 - y0));
  return std::isfinite(mean) ? float(mean) : 0;
}

/// values -> cumulated shares in [0, 1], one more; all alike where nothing is there. Returns the sum.
double cumulate(const float* values, size_t n, float* out) {
  double total = 0;
  for (size_t i = 0; i < n; ++i) total += double(values[i]);
  double sum = 0;
  for (size_t i = 0; i < n; ++i) {
    out[i] = total > 0 ? float(sum / total) : float(i) / float(n);
    sum += double(values[i]);
  }
  out[n] = 1;
  return total;
}

struct Found {
  size_t index;
  float rest;  // position within the cell, [0, 1)
};
Found find(const float* sums, size_t n, float u) {
  const size_t i = size_t(std::upper_bound(sums, sums + n + 1, u) - sums);
  const size_t index = std::min(i == 0 ? 0 : i - 1, n - 1);
  const float width = sums[index + 1] - sums[index];
  return {index, width > 0 ? std::min((u - sums[index]) / width, 0x1.fffffep-1f) : 0.5f};
}

}  // namespace

EnvironmentSampler::EnvironmentSampler(const EnvironmentLight& light) : light_(&light) {
  const Image& image = light.radiance;
  const float tint = std::max(luminance(light.colour.v), 0.0f);
  mean_ = tint;
  if (image.empty() || !(tint > 0)) return;
  columns_ = std::min(size_t(image.width), kMostColumns), rows_ = std::min(size_t(image.height), kMostColumns / 2);
  std::vector<float> cells(columns_ * rows_), row(rows_);
  parallel_for(rows_, 8, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y)
      for (size_t x = 0; x < columns_; ++x) cells[y * columns_ + x] = cell_luminance(image, x, y, columns_, rows_);
  });
  // Between texel centres the picture is interpolated: the mean of a cell has parts of the texels around, by 1/8, 3/4,
  // 1/8 along each axis.
  std::vector<float> blurred(columns_);
  column_sum_.resize((columns_ + 1) * rows_), row_sum_.resize(rows_ + 1);
  double total = 0, weight = 0;
  for (size_t y = 0; y < rows_; ++y) {
    const float* above = &cells[(y > 0 ? y - 1 : y) * columns_];
    const float* here = &cells[y * columns_];
    const float* below = &cells[std::min(y + 1, rows_ - 1) * columns_];
    for (size_t x = 0; x < columns_; ++x) {
      const size_t l = (x + columns_ - 1) % columns_, r = (x + 1) % columns_;
      const float edges = above[x] + here[l] + here[r] + below[x], corners = above[l] + above[r] + below[l] + below[r];
      blurred[x] = 9.0f / 16 * here[x] + 3.0f / 32 * edges + 1.0f / 64 * corners;
    }
    const double sine = std::sin(kPi * (double(y) + 0.5) / double(rows_));
    const double sum = cumulate(blurred.data(), columns_, &column_sum_[y * (columns_ + 1)]);
    row[y] = float(sum * sine);
    total += sum * sine, weight += double(columns_) * sine;
  }
  cumulate(row.data(), rows_, row_sum_.data());
  mean_ = tint * float(total / weight);
}

float EnvironmentSampler::cell_pdf(size_t column, size_t row) const {
  const float* sums = &column_sum_[row * (columns_ + 1)];
  const double share = double(row_sum_[row + 1] - row_sum_[row]) * double(sums[column + 1] - sums[column]);
  const double top = std::cos(kPi * double(row) / double(rows_)),
               bottom = std::cos(kPi * double(row + 1) / double(rows_));
  return float(share * double(columns_) / (2 * kPi * (top - bottom)));
}

EnvironmentSampler::Sample EnvironmentSampler::sample(Vec2 u) const {
  float y, turn, pdf = float(kInvPi / 4);
  if (columns_ == 0) {
    y = 1 - 2 * u.y, turn = u.x;
  } else {
    const Found row = find(row_sum_.data(), rows_, u.y);
    const Found column = find(&column_sum_[row.index * (columns_ + 1)], columns_, u.x);
    const float top = std::cos(float(kPi) * float(row.index) / float(rows_));
    const float bottom = std::cos(float(kPi) * float(row.index + 1) / float(rows_));
    y = top + (bottom - top) * row.rest;  // evenly over the cell's solid angle
    turn = (float(column.index) + column.rest) / float(columns_);
    pdf = cell_pdf(column.index, row.index);
  }
  const float phi = float(2 * kPi) * (turn - 0.5f) - light_->rotation, r = std::sqrt(std::max(0.0f, 1 - y * y));
  return {{r * std::sin(phi), y, -r * std::cos(phi)}, pdf};
}

float EnvironmentSampler::pdf(Vec3 direction) const {
  if (columns_ == 0) return float(kInvPi / 4);
  const float u = (std::atan2(direction.x, -direction.z) + light_->rotation) * float(0.5 * kInvPi) + 0.5f;
  const float v = std::acos(std::clamp(direction.y, -1.0f, 1.0f)) * float(kInvPi);
  const auto column = std::min(size_t((u - std::floor(u)) * float(columns_)), columns_ - 1);
  return cell_pdf(column, std::min(size_t(v * float(rows_)), rows_ - 1));
}

}  // namespace aktina
