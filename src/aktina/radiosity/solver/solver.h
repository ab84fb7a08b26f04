// The solvers of the radiosity equation, behind one interface.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "aktina/base/method.h"
#include "aktina/radiosity/solver/problem.h"

namespace aktina {

class RadiositySolver {
 public:
  virtual ~RadiositySolver() = default;
  /// What is done when `control` stops it is returned, with converged = false. The same values for any number of
  /// threads. @throws Error limit
  virtual RadiosityState solve(const RadiosityProblem& problem, const FactorSource& factors,
                               const SolverControl& control) const = 0;
  /// Whether factors must keep A_i F_ij = A_j F_ji.
  virtual bool needs_reciprocity() const { return false; }
  /// Whether it computes no finer than SolverControl::view needs.
  virtual bool uses_importance() const { return false; }
};

using RadiositySolverRow = Method<std::unique_ptr<RadiositySolver>>;
std::span<const RadiositySolverRow* const> solvers();

/// Patches whose form factors are known.
struct RadiositySystem {
  size_t patches = 0, bands = 1;
  std::span<const double> factors;       // F_ij, patches x patches, row by row
  std::span<const double> emissions;     // E, patches x bands, row by row
  std::span<const double> reflectances;  // rho in [0, 1), patches x bands
};

/// B = E + rho F B for each band, in the unit of E.
/// @param solver     as solvers() lists them
/// @param tolerance  relative: of the largest B (matrix), of the emitted flux (progressive); stochastic_jacobi samples
/// to 0.002 at best
/// @return B, patches x bands, row by row
/// @throws Error bad_param (a value that is not finite or negative, a reflectance of 1 and above or a reflectance times
/// a row's sum of 1 and above: no finite solution; factors without reciprocity where the solver needs it),
/// no_such_method
std::vector<double> solve_radiosity_system(const RadiositySystem& system, std::string_view solver = "matrix",
                                           double tolerance = 1e-12, Progress* progress = nullptr);

}  // namespace aktina
