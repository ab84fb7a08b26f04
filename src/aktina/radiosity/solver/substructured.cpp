// Substructuring: patches shoot, their elements receive. The light is balanced by progressive refinement; then elements
// within which it changes fast are split, the new ones receive what every patch has shot so far, and the patches shoot
// what they have come to reflect otherwise; until nothing is left to be split. Where elements cannot be split it is
// progressive refinement with the elements that there are.
// Cost: form factors of patches times elements, not of elements times elements; those of new elements only at a split.
// Weakness: patches shoot evenly, however their elements differ; what the first elements miss is not found.
//
// M. Cohen, D. Greenberg, D. Immel, P. Brock, "An Efficient Radiosity Approach for Realistic Image Synthesis", IEEE
// CG&A 6(3), 1986; progressive: M. Cohen, S. Chen, J. Wallace, D. Greenberg, SIGGRAPH 1988.
#include "aktina/radiosity/solver/progressive_refinement.h"

namespace aktina {
namespace {

class SubstructuredSolver final : public RadiositySolver {
 public:
  RadiosityState solve(const RadiosityProblem& problem, const FactorSource& factors,
                       const SolverControl& control) const override {
    ProgressiveRefinement refinement(problem);
    if (control.progress) control.progress->begin("solving", "shots", 0);
    refinement.run(factors, control);
    while (control.splitter && !control.stopped(refinement.state().steps) &&
           refinement.split(*control.splitter, control))
      refinement.run(control.splitter->factors(), control);
    return refinement.finish(control);
  }
};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> substructured_radiosity = {
    {"substructured", "Substructuring into patches and elements", "cohen1986",
     "Patches shoot, elements receive and are split where light changes fast (mesher quadtree); new ones receive anew, "
     "the others keep their light."},
    [](const ParamSet&) -> std::unique_ptr<RadiositySolver> { return std::make_unique<SubstructuredSolver>(); }};

}  // namespace aktina
