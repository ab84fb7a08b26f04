// All form factors of a problem, and its linear system (I - K) B = E' for each band, where K_jk is the share of the
// radiosity of k that j reflects, and E' = E + rho H0. B are mean radiosities of what shoots.
#pragma once

#include <vector>

#include "aktina/radiosity/checkpoint.h"
#include "aktina/radiosity/solver/problem.h"

namespace aktina {

class FactorMatrix {
 public:
  /// Computes the factors; leaves out what is not done when `control` is cancelled. `problem` must outlive this.
  /// @throws Error limit (more than 2^28 factors)
  FactorMatrix(const RadiosityProblem& problem, const FactorSource& source, const SolverControl& control);

  size_t size() const { return columns_; }
  size_t bands() const { return p_.bands; }
  double area(size_t j) const { return areas_[j]; }
  double reflectance(size_t j, size_t band) const { return reflectances_[j * p_.bands + band]; }
  /// E' of a band.
  std::vector<double> right_side(size_t band) const;
  /// (K x)_j
  double row_times(size_t j, size_t band, const std::vector<double>& x) const;
  /// K x
  std::vector<double> times(size_t band, const std::vector<double>& x) const;
  /// K_jk
  double entry(size_t j, size_t k, size_t band) const;
  /// The largest sum of a row of K: errors shrink at least by this when light goes from surface to surface once.
  double contraction() const;

  /// Irradiances of all receivers from radiosities of what shoots, by shooter and band.
  std::vector<double> irradiances(const std::vector<double>& radiosities) const;
  /// Area means over what shoots of values by receiver and band.
  std::vector<double> means(const std::vector<double>& values) const;

 private:
  const RadiosityProblem& p_;
  size_t columns_;
  KeptList<double> factors_;  // by receiver and shooter
  std::vector<double> areas_, reflectances_;
};

}  // namespace aktina
