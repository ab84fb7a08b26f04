#include "aktina/radiosity/solver/factor_matrix.h"

#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"

namespace aktina {
namespace {

constexpr double kMostEntries = 1 << 28;  // 2 GiB

double dot(const double* a, const double* b, size_t n) {
  double sums[4] = {0, 0, 0, 0};  // side by side: additions do not wait for each other
  size_t k = 0;
  for (; k + 4 <= n; k += 4)
    for (size_t lane = 0; lane < 4; ++lane) sums[lane] += a[k + lane] * b[k + lane];
  for (; k < n; ++k) sums[0] += a[k] * b[k];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

size_t checked_count(const RadiosityProblem& p) {
  if (double(p.size()) * double(p.shooters.size()) > kMostEntries)
    throw Error(Code::limit, "matrix", fmt::format("{} x {} form factors", p.size(), p.shooters.size()),
                "larger patches, indirect light on coarser ones, or the stochastic_jacobi solver");
  return p.size() * p.shooters.size();
}

}  // namespace

FactorMatrix::FactorMatrix(const RadiosityProblem& p, const FactorSource& source, const SolverControl& control)
    : p_(p), columns_(p.shooters.size()), factors_(control.checkpoint, "form factors", checked_count(p)) {
  std::vector<double> column(p.size());
  if (control.progress) control.progress->begin("form factors", "columns", columns_);
  factors_.loop.run(columns_, 1, control.progress, [&](size_t begin, size_t end) {
    for (size_t j = begin; j < end && !control.stopped(0); ++j) {
      source.column(j, column);
      for (size_t s = 0; s < p.size(); ++s) factors_.values[s * columns_ + j] = column[s];
      if (control.progress) control.progress->advance();
    }
  });
  for (const RadiosityProblem::Range range : p.shooters) {
    double area = 0;
    for (size_t s = range.first; s < range.first + range.count; ++s) area += p.areas[s];
    areas_.push_back(area);
  }
  reflectances_ = means(p.reflectances);
}

std::vector<double> FactorMatrix::means(const std::vector<double>& values) const {
  std::vector<double> sums(columns_ * p_.bands, 0);
  for (size_t j = 0; j < columns_; ++j) {
    const auto range = p_.shooters[j];
    for (size_t s = range.first; s < range.first + range.count; ++s)
      for (size_t b = 0; b < p_.bands; ++b)
        sums[j * p_.bands + b] += p_.areas[s] / areas_[j] * values[s * p_.bands + b];
  }
  return sums;
}

std::vector<double> FactorMatrix::right_side(size_t band) const {
  std::vector<double> own = p_.emissions;
  for (size_t k = 0; k < p_.arriving.size(); ++k) own[k] += p_.reflectances[k] * p_.arriving[k];
  own = means(own);
  std::vector<double> e(columns_);
  for (size_t j = 0; j < columns_; ++j) e[j] = own[j * p_.bands + band];
  return e;
}

double FactorMatrix::row_times(size_t j, size_t band, const std::vector<double>& x) const {
  const auto range = p_.shooters[j];
  double sum = 0;
  for (size_t s = range.first; s < range.first + range.count; ++s)
    sum += p_.areas[s] / areas_[j] * p_.reflectances[s * p_.bands + band] *
           dot(&factors_.values[s * columns_], x.data(), columns_);
  return sum;
}

std::vector<double> FactorMatrix::times(size_t band, const std::vector<double>& x) const {
  std::vector<double> y(columns_);
  parallel_for(columns_, 16, [&](size_t begin, size_t end) {
    for (size_t j = begin; j < end; ++j) y[j] = row_times(j, band, x);
  });
  return y;
}

double FactorMatrix::entry(size_t j, size_t k, size_t band) const {
  const auto range = p_.shooters[j];
  double sum = 0;
  for (size_t s = range.first; s < range.first + range.count; ++s)
    sum += p_.areas[s] / areas_[j] * p_.reflectances[s * p_.bands + band] * factors_.values[s * columns_ + k];
  return sum;
}

double FactorMatrix::contraction() const {
  const std::vector<double> ones(columns_, 1);
  double largest = 0;
  for (size_t b = 0; b < p_.bands; ++b)
    for (const double sum : times(b, ones)) largest = std::max(largest, sum);
  return std::min(largest, 0.999999);
}

std::vector<double> FactorMatrix::irradiances(const std::vector<double>& radiosities) const {
  std::vector<double> h(p_.size() * p_.bands);
  parallel_for(p_.size(), 64, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s)
      for (size_t b = 0; b < p_.bands; ++b) {
        double sum = p_.arriving.empty() ? 0 : p_.arriving[s * p_.bands + b];
        for (size_t j = 0; j < columns_; ++j) sum += factors_.values[s * columns_ + j] * radiosities[j * p_.bands + b];
        h[s * p_.bands + b] = sum;
      }
  });
  return h;
}

}  // namespace aktina
