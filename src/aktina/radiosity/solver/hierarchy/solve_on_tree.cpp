// From coarse links to fine ones, light exchanged in between; then exchanges until nothing changes any more.
#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/radiosity/solver/hierarchy/hierarchy.h"

namespace aktina {
namespace {

constexpr double kPasses[] = {64, 16, 4, 1};  // times the final threshold
constexpr int kExchanges = 3;                 // before links are refined again

class TreeSolve {
 public:
  TreeSolve(const RadiosityProblem& problem, LinkedTree& hierarchy, const SolverControl& control)
      : problem_(problem), hierarchy_(hierarchy), control_(control) {
    state_.emitted = problem.emitted();
  }

  RadiosityState run() {
    for (const double times : kPasses) {
      if (control_.progress) control_.progress->begin("linking", "links", 0);
      hierarchy_.link(times, control_.progress);
      if (control_.progress) control_.progress->begin("solving", "exchanges", 0);
      for (int k = 0; k < kExchanges && !control_.stopped(state_.steps); ++k) step();
      if (control_.stopped(state_.steps)) return finished(false);
    }
    while (changed_ > control_.tolerance * state_.emitted && !control_.stopped(state_.steps)) step();
    return finished(changed_ <= control_.tolerance * state_.emitted);
  }

 private:
  void step() {
    changed_ = hierarchy_.exchange();
    ++state_.steps;
    if (control_.progress) control_.progress->advance();
    if (!control_.each_step) return;
    account();
    state_.direct = problem_.arriving;
    state_.direct.resize(state_.irradiances.size(), 0);
    control_.each_step(state_);
  }

  void account() {
    state_.irradiances = hierarchy_.light().receivers();
    const std::vector<double> before = hierarchy_.light().receivers_before();
    state_.unshot.resize(before.size());
    for (size_t k = 0; k < before.size(); ++k)
      state_.unshot[k] = problem_.reflectances[k] * (state_.irradiances[k] - before[k]);
    state_.absorbed = absorbed_flux(problem_, state_);
    state_.escaped = state_.emitted - state_.absorbed - unshot_flux(problem_, state_);
    state_.unshot_share = state_.emitted > 0 ? changed_ / state_.emitted : 0;
  }

  RadiosityState finished(bool converged) {
    account();
    state_.converged = converged;
    hierarchy_.light().emit_only();
    hierarchy_.exchange();
    state_.direct = hierarchy_.light().receivers();
    return std::move(state_);
  }

  const RadiosityProblem& problem_;
  LinkedTree& hierarchy_;
  const SolverControl& control_;
  RadiosityState state_;
  double changed_ = 0;
};

}  // namespace

RadiosityState solve_on_tree(std::string_view method, const RadiosityProblem& problem, const FactorSource& factors,
                             const SolverControl& control, HierarchyOptions options) {
  const ReceiverSurfaces* surfaces = factors.surfaces();
  if (!surfaces)
    throw Error(Code::unsupported, std::string(method), "cuts surfaces itself, and these form factors have none",
                "formfactor=ray_cast, or a solver for given factors as matrix");
  options.view = control.view;
  LinkedTree hierarchy(problem, *surfaces, options, control.seed);
  return TreeSolve(problem, hierarchy, control).run();
}

}  // namespace aktina
