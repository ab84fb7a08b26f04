#include "aktina/radiosity/solver/hierarchy/wavelet.h"

#include <cmath>

#include "aktina/radiosity/solver/hierarchy/hierarchy.h"

namespace aktina {
namespace {

class WaveletSolver final : public RadiositySolver {
 public:
  WaveletSolver(std::string_view method, Basis basis, double most)
      : method_(method), basis_(std::move(basis)), most_(most) {}
  RadiosityState solve(const RadiosityProblem& problem, const FactorSource& factors,
                       const SolverControl& control) const override {
    HierarchyOptions options;
    options.basis = basis_, options.spread = Transport::Spread::interpolation;
    options.most = most_ * std::pow(control.target_error, 5.0 / 3);
    return solve_on_tree(method_, problem, factors, control, options);
  }
  bool uses_importance() const override { return true; }

 private:
  std::string_view method_;
  Basis basis_;
  double most_;
};

}  // namespace

std::unique_ptr<RadiositySolver> wavelet_solver(std::string_view method, Basis basis, double most) {
  return std::make_unique<WaveletSolver>(method, std::move(basis), most);
}

}  // namespace aktina
