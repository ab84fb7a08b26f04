// Hierarchical radiosity: surfaces are cut into quarters of quarters, and light is exchanged between nodes as large as
// the error of their link allows: of n elements there are links in the order of n, not n^2, beside those between every
// two surfaces. Cost: 16 bytes a link, two to four rays; memory grows with the links. Weakness: every two surfaces are
// looked at, so many small ones cost the square of their number; constant elements show their edges.
//
// P. Hanrahan, D. Salzman, L. Aupperle, "A Rapid Hierarchical Radiosity Algorithm", SIGGRAPH '91.
#include <cmath>

#include "aktina/radiosity/solver/hierarchy/hierarchy.h"

namespace aktina {
namespace {

/// What a link may not exceed at a relative error of irradiances: fitted to rooms with and without boxes
/// (docs/radiosity.md).
double most_of(Oracle oracle, double error) {
  if (oracle == Oracle::factor) return 6 * std::pow(error, 1.8);
  return 0.02 * std::pow(error, 5.0 / 3);
}

class HierarchicalSolver final : public RadiositySolver {
 public:
  explicit HierarchicalSolver(Oracle oracle) : oracle_(oracle) {}
  RadiosityState solve(const RadiosityProblem& problem, const FactorSource& factors,
                       const SolverControl& control) const override {
    HierarchyOptions options;
    options.oracle = oracle_, options.most = most_of(oracle_, control.target_error);
    return solve_on_tree("hierarchical", problem, factors, control, options);
  }
  bool uses_importance() const override { return true; }

 private:
  Oracle oracle_;
};

constexpr Param kParams[] = {
    {"oracle", "1", "what a link may not exceed: 0 form factor, 1 flux it carries (BF), 2 flux it carries wrongly", 2,
     0, 2, true}};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> hierarchical_radiosity = {
    {"hierarchical", "Hierarchical radiosity", "hanrahan1991",
     "Links nodes of quadtrees as coarsely as the error allows; no noise; for scenes of up to some thousand faces.",
     kParams},
    [](const ParamSet& p) -> std::unique_ptr<RadiositySolver> {
      return std::make_unique<HierarchicalSolver>(Oracle(int(p["oracle"])));
    }};

}  // namespace aktina
