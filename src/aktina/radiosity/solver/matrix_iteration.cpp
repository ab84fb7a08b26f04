#include "aktina/radiosity/solver/matrix_iteration.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/radiosity/checkpoint.h"

namespace aktina {
namespace {

constexpr uint64_t kMostSweeps = 10'000'000;
constexpr double kRounding = 4e-15;  // of an exchange of light, relative: errors below it over 1 - rho are noise

void renew_residual(BandSystem& s) {
  s.residual = s.matrix.times(s.band, s.x);
  for (size_t j = 0; j < s.x.size(); ++j) s.residual[j] += s.right_side[j] - s.x[j];
}

/// Bound of the error, relative to the largest radiosity of all bands.
double error_left(const std::vector<BandSystem>& systems, double contraction) {
  double residual = 0, largest = 0;
  for (const BandSystem& s : systems)
    for (size_t j = 0; j < s.x.size(); ++j) {
      residual = std::max(residual, std::abs(s.residual[j]));
      largest = std::max(largest, std::abs(s.x[j]));
    }
  return residual > 0 ? residual / (1 - contraction) / largest : 0;
}

/// Energy accounting: what another exchange of light would change counts as not yet distributed.
void account(const RadiosityProblem& p, const FactorMatrix& matrix, const std::vector<BandSystem>& systems,
             RadiosityState& state) {
  std::vector<double> radiosities(matrix.size() * p.bands);
  for (const BandSystem& s : systems)
    for (size_t j = 0; j < matrix.size(); ++j) radiosities[j * p.bands + s.band] = s.x[j];
  state.irradiances = matrix.irradiances(radiosities);
  state.unshot.assign(state.irradiances.size(), 0);
  for (const BandSystem& s : systems)
    for (size_t j = 0; j < matrix.size(); ++j)
      for (size_t i = p.shooters[j].first; i < p.shooters[j].first + p.shooters[j].count; ++i)
        state.unshot[i * p.bands + s.band] = s.residual[j];
  state.absorbed = absorbed_flux(p, state);
  const double left = unshot_flux(p, state);
  state.unshot_share = state.emitted > 0 ? std::abs(left) / state.emitted : 0;
  state.escaped = state.emitted - state.absorbed - left;
}

}  // namespace

RadiosityState solve_by_sweeps(const RadiosityProblem& problem, const FactorSource& factors,
                               const SolverControl& control, FunctionRef<std::unique_ptr<MatrixIteration>()> make) {
  const FactorMatrix matrix(problem, factors, control);
  const double contraction = matrix.contraction();
  RadiosityState state;
  state.emitted = problem.emitted();
  state.direct = matrix.irradiances(matrix.means(problem.emissions));
  std::vector<BandSystem> systems;
  std::vector<std::unique_ptr<MatrixIteration>> iterations;
  for (size_t b = 0; b < problem.bands; ++b) {
    systems.push_back({matrix, b, matrix.right_side(b), {}, {}});
    systems.back().x = systems.back().right_side;
    renew_residual(systems.back());
    iterations.push_back(make());
  }
  const CheckpointPart kept(control.checkpoint, "sweeps", [&](Archive& a) {
    a(state.steps);
    for (size_t b = 0; b < systems.size(); ++b)
      a(systems[b].x), a(systems[b].residual), iterations[b]->archive(a, systems[b].x.size());
  });
  if (control.progress) control.progress->begin("solving", "sweeps", 0);
  double left = error_left(systems, contraction);
  const double tolerance = std::max(control.tolerance, kRounding / (1 - contraction));
  while (left > tolerance && state.steps < kMostSweeps && !control.stopped(state.steps)) {
    for (size_t b = 0; b < problem.bands; ++b) iterations[b]->sweep(systems[b]), renew_residual(systems[b]);
    left = error_left(systems, contraction);
    ++state.steps;
    if (control.progress) control.progress->advance();
    if (control.each_step) account(problem, matrix, systems, state), control.each_step(state);
    kept.save_when_due();
  }
  account(problem, matrix, systems, state);
  state.converged = left <= tolerance;
  return state;
}

}  // namespace aktina
