// Progressive refinement: again and again the shooter with the most light not yet distributed sends it to all
// receivers. Cost: one column of form factors a step, memory of the order of the receivers; a useful picture after few
// steps. Weakness: the last per cent takes as long as the matrix method; columns are computed again when a shooter's
// turn comes again.
//
// M. Cohen, S. Chen, J. Wallace, D. Greenberg, "A Progressive Refinement Approach to Fast Radiosity Image Generation",
// SIGGRAPH 1988.
#include "aktina/radiosity/solver/progressive_refinement.h"

namespace aktina {
namespace {

class ProgressiveSolver final : public RadiositySolver {
 public:
  RadiosityState solve(const RadiosityProblem& problem, const FactorSource& factors,
                       const SolverControl& control) const override {
    ProgressiveRefinement refinement(problem);
    if (control.progress) control.progress->begin("solving", "shots", 0);
    refinement.run(factors, control);
    return refinement.finish(control);
  }
};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> progressive_radiosity = {
    {"progressive", "Progressive refinement", "cohen1988",
     "Shoots the brightest light not yet distributed first; a useful picture after few steps, little memory."},
    [](const ParamSet&) -> std::unique_ptr<RadiositySolver> { return std::make_unique<ProgressiveSolver>(); }};

}  // namespace aktina
