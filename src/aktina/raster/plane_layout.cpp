#include "aktina/raster/plane_layout.h"

#include <cmath>
#include <utility>

namespace aktina {
namespace {

/// The inverse of the matrix of monomials at the points of the lattice.
std::vector<float> interpolation_matrix(int degree) {
  const auto points = lattice(degree);
  const size_t n = points.size();
  std::vector<double> a(n * 2 * n);  // [monomials | identity], by Gauss and Jordan
  for (size_t row = 0; row < n; ++row) {
    size_t column = 0;
    for (int sum = 0; sum <= degree; ++sum)
      for (int v = 0; v <= sum; ++v)
        a[row * 2 * n + column++] = std::pow(double(points[row][1]), sum - v) * std::pow(double(points[row][2]), v);
    a[row * 2 * n + n + row] = 1;
  }
  const auto at = [&](size_t row, size_t column) -> double& { return a[row * 2 * n + column]; };
  for (size_t pivot = 0; pivot < n; ++pivot) {
    size_t best = pivot;
    for (size_t row = pivot; row < n; ++row)
      if (std::abs(at(row, pivot)) > std::abs(at(best, pivot))) best = row;
    for (size_t column = 0; column < 2 * n; ++column) std::swap(at(pivot, column), at(best, column));
    const double scale = 1 / at(pivot, pivot);
    for (size_t column = 0; column < 2 * n; ++column) at(pivot, column) *= scale;
    for (size_t row = 0; row < n; ++row) {
      const double factor = at(row, pivot);
      if (row == pivot || factor == 0) continue;
      for (size_t column = 0; column < 2 * n; ++column) at(row, column) -= factor * at(pivot, column);
    }
  }
  std::vector<float> out(n * n);
  for (size_t row = 0; row < n; ++row)
    for (size_t column = 0; column < n; ++column) {
      const double exact = at(row, n + column);
      const double halves = std::round(exact * 2) / 2;  // they are whole multiples of 1/2: not to keep rounding errors
      out[row * n + column] = float(std::abs(exact - halves) < 1e-5 ? halves : exact);
    }
  return out;
}

}  // namespace

const float* lattice_to_polynomial(int degree) {
  static const std::vector<float> kQuadratic = interpolation_matrix(2), kCubic = interpolation_matrix(3);
  return degree == 2 ? kQuadratic.data() : kCubic.data();
}

}  // namespace aktina
