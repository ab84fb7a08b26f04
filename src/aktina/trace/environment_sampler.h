// Directions towards the bright parts of the sky.
#pragma once

#include <vector>

#include "aktina/scene/scene.h"

namespace aktina {

/// Directions with a density that follows the luminance of an environment, in cells of at most 1/1024 of a turn; all
/// directions alike where it has no picture. Cost: two binary searches.
class EnvironmentSampler {
 public:
  /// `light` must outlive this.
  explicit EnvironmentSampler(const EnvironmentLight& light);

  bool shines() const { return mean_ > 0; }
  /// Luminance averaged over all directions, cd/m^2.
  float mean_luminance() const { return mean_; }
  struct Sample {
    Vec3 direction;
    float pdf;  // sr^-1
  };
  Sample sample(Vec2 u) const;
  float pdf(Vec3 direction) const;

 private:
  float cell_pdf(size_t column, size_t row) const;

  const EnvironmentLight* light_;
  size_t columns_ = 0, rows_ = 0;
  float mean_ = 0;
  std::vector<float> row_sum_;     // cumulated over rows, rows_ + 1 values, the last 1
  std::vector<float> column_sum_;  // the same within each row
};

}  // namespace aktina
