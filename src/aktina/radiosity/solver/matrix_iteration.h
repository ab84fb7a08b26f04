// What the matrix solvers share: form factors, sweeps until the error is small, accounting.
#pragma once

#include <memory>

#include "aktina/base/function_ref.h"
#include "aktina/radiosity/solver/factor_matrix.h"
#include "aktina/radiosity/solver/solver.h"

namespace aktina {

/// One band's system, and where its solution stands.
struct BandSystem {
  const FactorMatrix& matrix;
  size_t band;
  std::vector<double> right_side;
  std::vector<double> x;         // radiosities so far
  std::vector<double> residual;  // right_side - (I - K) x
};

/// A way to improve x. One object a band; it may remember what it likes from sweep to sweep.
class MatrixIteration {
 public:
  virtual ~MatrixIteration() = default;
  /// About as much work as one product with the matrix. Changes x; `residual` is renewed afterwards.
  virtual void sweep(BandSystem& system) = 0;
  /// What it remembers. @param n  length of x
  virtual void archive(Archive&, size_t /*n*/) {}
};

/// Sweeps until the residual bounds the error by `control.tolerance` of the largest radiosity. Cost: the form factors,
/// then two products with the matrix a sweep and band, one of them for the residual.
template <class Iteration>
class MatrixSolver final : public RadiositySolver {
 public:
  explicit MatrixSolver(const Iteration& first) : first_(first) {}
  RadiosityState solve(const RadiosityProblem& problem, const FactorSource& factors,
                       const SolverControl& control) const override;

 private:
  Iteration first_;
};

RadiosityState solve_by_sweeps(const RadiosityProblem& problem, const FactorSource& factors,
                               const SolverControl& control, FunctionRef<std::unique_ptr<MatrixIteration>()> make);

template <class Iteration>
RadiosityState MatrixSolver<Iteration>::solve(const RadiosityProblem& problem, const FactorSource& factors,
                                              const SolverControl& control) const {
  return solve_by_sweeps(problem, factors, control, [&] { return std::make_unique<Iteration>(first_); });
}

}  // namespace aktina
