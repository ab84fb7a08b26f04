// Sums that do not lose digits, and running mean and variance.
#pragma once

#include <cmath>
#include <cstdint>

namespace aktina {

/// Neumaier's compensated summation: error about one rounding, whatever the number of terms.
class Sum {
 public:
  void add(double x) {
    const double t = sum_ + x;
    rest_ += std::abs(sum_) >= std::abs(x) ? (sum_ - t) + x : (x - t) + sum_;
    sum_ = t;
  }
  double value() const { return sum_ + rest_; }

 private:
  double sum_ = 0, rest_ = 0;
};

/// Welford, "Note on a Method for Calculating Corrected Sums of Squares and Products", Technometrics 4(3), 1962.
class RunningStatistics {
 public:
  void add(double x) {
    ++count_;
    const double delta = x - mean_;
    mean_ += delta / double(count_);
    squares_ += delta * (x - mean_);
  }
  uint64_t count() const { return count_; }
  double mean() const { return mean_; }
  double variance() const { return count_ > 1 ? squares_ / double(count_ - 1) : 0; }
  double standard_error() const { return count_ > 1 ? std::sqrt(variance() / double(count_)) : INFINITY; }

 private:
  uint64_t count_ = 0;
  double mean_ = 0, squares_ = 0;
};

}  // namespace aktina
