// Overshooting: progressive refinement whose shooters also send, in advance, what they will come to reflect of the
// light that the others have not yet distributed, by the ambient estimate; then they owe it. Cost: fewer columns of
// form factors than progressive refinement, by a factor that grows with the reflectances; a sum over the receivers a
// step. Weakness: until the end some of the light is a guess; nothing is gained in dark or open scenes.
//
// M. Feda, W. Purgathofer, "Accelerating Radiosity by Overshooting", Eurographics Workshop on Rendering 1992.
#include "aktina/radiosity/solver/progressive_refinement.h"

namespace aktina {
namespace {

class OvershootingSolver final : public RadiositySolver {
 public:
  RadiosityState solve(const RadiosityProblem& problem, const FactorSource& factors,
                       const SolverControl& control) const override {
    ProgressiveRefinement refinement(problem, ProgressiveRefinement::Shot::with_ambient);
    if (control.progress) control.progress->begin("solving", "shots", 0);
    refinement.run(factors, control);
    return refinement.finish(control);
  }
};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> overshooting_radiosity = {
    {"overshooting", "Progressive refinement with overshooting", "feda1992",
     "Shoots with its own light what it expects to reflect of the others'; fewer shots in bright closed rooms."},
    [](const ParamSet&) -> std::unique_ptr<RadiositySolver> { return std::make_unique<OvershootingSolver>(); }};

}  // namespace aktina
