// Rays for form factors that are known as numbers only.
#pragma once

#include <vector>

#include "aktina/radiosity/checkpoint.h"
#include "aktina/radiosity/solver/problem.h"

namespace aktina {

/// A ray from a receiver arrives at what shoots with the probability of its form factor, and there at a member by its
/// area; beyond the sum of the factors it escapes. All factors are computed and kept.
class MatrixRays final : public LightRays {
 public:
  /// `problem` must outlive this. @throws Error limit (more than 2^28 factors)
  MatrixRays(const RadiosityProblem& problem, const FactorSource& factors, const SolverControl& control);
  void follow(std::span<const Ray> rays, std::vector<Arrival>& arrivals) const override;

 private:
  const RadiosityProblem& problem_;
  KeptList<double> sums_;      // of the factors of a receiver to all shooters up to and with each
  std::vector<double> areas_;  // sums over receivers
  uint32_t seed_;
};

}  // namespace aktina
