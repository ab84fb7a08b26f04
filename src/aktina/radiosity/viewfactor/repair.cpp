#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/statistics.h"
#include "aktina/radiosity/viewfactor/certificate.h"

namespace aktina {
namespace {

constexpr double kNoEnclosure = 0.1;
constexpr double kConverged = 1e-15;  // of the area of the surfaces
constexpr size_t kMostSteps = 1000;

/// The rows' sums of exchange areas times (l_i + l_j).
class RowChanges {
 public:
  explicit RowChanges(const ViewFactors& f) : f_(f), sums_(f.size()) {
    for (size_t i = 0; i < f.size(); ++i) sums_[i] = f.areas[i] * f.row_sum(i);
  }
  double missing(size_t i) const { return f_.areas[i] - sums_[i]; }

  std::vector<double> operator()(const std::vector<double>& l) const {
    std::vector<double> changes(l.size());
    for (size_t i = 0; i < l.size(); ++i) {
      Sum sum;
      for (uint64_t k = f_.starts[i]; k < f_.starts[i + 1]; ++k) sum.add(f_.factors[k] * l[f_.columns[k]]);
      changes[i] = sums_[i] * l[i] + f_.areas[i] * sum.value();
    }
    return changes;
  }

 private:
  const ViewFactors& f_;
  std::vector<double> sums_;
};

double product(const std::vector<double>& a, const std::vector<double>& b) {
  Sum sum;
  for (size_t i = 0; i < a.size(); ++i) sum.add(a[i] * b[i]);
  return sum.value();
}

/// Conjugate gradients: the matrix is symmetric and not negative.
std::vector<double> multipliers(const RowChanges& matrix, std::vector<double> rest, double small) {
  std::vector<double> l(rest.size(), 0), direction = rest;
  double squared = product(rest, rest);
  for (size_t step = 0; step < kMostSteps && squared > small * small; ++step) {
    const std::vector<double> image = matrix(direction);
    const double curvature = product(direction, image);
    if (!(curvature > 0)) break;
    const double length = squared / curvature;
    for (size_t i = 0; i < l.size(); ++i) l[i] += length * direction[i], rest[i] -= length * image[i];
    const double before = squared;
    squared = product(rest, rest);
    for (size_t i = 0; i < l.size(); ++i) direction[i] = rest[i] + squared / before * direction[i];
  }
  return l;
}

}  // namespace

double repair(ViewFactors& f) {
  const RowChanges matrix(f);
  std::vector<double> missing;
  for (size_t i = 0; i < f.size(); ++i) {
    missing.push_back(matrix.missing(i));
    if (std::abs(missing[i]) > kNoEnclosure * f.areas[i])
      throw Error(Code::bad_input, f.names[i], fmt::format("its view factors sum to {:.4f}", f.row_sum(i)),
                  "only closed enclosures can be repaired");
  }
  double area = 0, largest = 0;
  for (const double a : f.areas) area += a;
  const std::vector<double> l = multipliers(matrix, missing, kConverged * area);
  for (size_t i = 0; i < f.size(); ++i)
    for (uint64_t k = f.starts[i]; k < f.starts[i + 1]; ++k) {
      const double change = f.factors[k] * (l[i] + l[f.columns[k]]);
      largest = std::max(largest, std::abs(change));
      f.factors[k] += change;
    }
  return largest;
}

}  // namespace aktina
