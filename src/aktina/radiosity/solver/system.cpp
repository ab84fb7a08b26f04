// Radiosity of patches whose form factors are known.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/radiosity/solver/solver.h"

namespace aktina {
namespace {

constexpr double kReciprocity = 1e-4;  // relative
constexpr double kLeastError = 2e-3;   // that samples are asked for

class GivenFactors final : public FactorSource {
 public:
  explicit GivenFactors(const RadiositySystem& system) : system_(system) {}
  void column(size_t shooter, std::span<double> factors) const override {
    for (size_t s = 0; s < factors.size(); ++s) factors[s] = system_.factors[s * system_.patches + shooter];
  }

 private:
  const RadiositySystem& system_;
};

void check_size(const char* name, std::span<const double> values, size_t rows, size_t columns) {
  if (values.size() != rows * columns)
    throw Error(Code::usage, name, fmt::format("has {} values", values.size()), fmt::format("{} x {}", rows, columns));
  for (const double v : values)
    if (!(v >= 0 && std::isfinite(v)))
      throw Error(Code::bad_param, name, fmt::format("got {}", v), "accepted 0 .. inf");
}

void check(const RadiositySystem& system) {
  check_size("F", system.factors, system.patches, system.patches);
  check_size("E", system.emissions, system.patches, system.bands);
  check_size("rho", system.reflectances, system.patches, system.bands);
  for (size_t i = 0; i < system.patches; ++i) {
    double sum = 0;
    for (const double f : system.factors.subspan(i * system.patches, system.patches)) sum += f;
    for (const double rho : system.reflectances.subspan(i * system.bands, system.bands))
      if (rho >= 1 || rho * sum >= 1)
        throw Error(Code::bad_param, fmt::format("rho[{}]", i),
                    fmt::format("got {}, with form factors that sum to {}: no finite solution", rho, sum),
                    "light must lose energy at every reflection: accepted 0 .. below 1");
  }
}

/// Areas that A_i F_ij = A_j F_ji asks for, in that of the first patch of each group that sees each other; empty where
/// no areas do.
std::vector<double> reciprocal_areas(const RadiositySystem& system) {
  const size_t n = system.patches;
  const auto f = [&](size_t i, size_t j) { return system.factors[i * n + j]; };
  std::vector<double> areas(n, 0);
  std::vector<size_t> open;
  for (size_t first = 0; first < n; ++first) {
    if (areas[first] > 0) continue;
    areas[first] = 1, open.push_back(first);
    while (!open.empty()) {
      const size_t i = open.back();
      open.pop_back();
      for (size_t j = 0; j < n; ++j)
        if (areas[j] == 0 && f(i, j) > 0 && f(j, i) > 0) areas[j] = areas[i] * f(i, j) / f(j, i), open.push_back(j);
    }
  }
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < i; ++j) {
      const double out = areas[i] * f(i, j), back = areas[j] * f(j, i);
      if (!(std::abs(out - back) <= kReciprocity * (out + back))) return {};
    }
  return areas;
}

}  // namespace

std::vector<double> solve_radiosity_system(const RadiositySystem& system, std::string_view solver, double tolerance,
                                           Progress* progress) {
  const auto method = make_method(solvers(), "radiosity", solver);
  check(system);
  RadiosityProblem problem;
  problem.bands = system.bands;
  problem.weights.assign(system.bands, 1);
  problem.areas = reciprocal_areas(system);
  if (problem.areas.empty() && method->needs_reciprocity())
    throw Error(Code::bad_param, "F", "no areas fit these form factors: A_i F_ij is not A_j F_ji",
                "form factors that keep reciprocity, or another solver");
  if (problem.areas.empty()) problem.areas.assign(system.patches, 1);
  problem.emissions.assign(system.emissions.begin(), system.emissions.end());
  problem.reflectances.assign(system.reflectances.begin(), system.reflectances.end());
  problem.shoot_one_by_one();
  SolverControl control;
  control.tolerance = tolerance;
  control.target_error = std::max(tolerance, kLeastError);
  control.progress = progress;
  const RadiosityState state = method->solve(problem, GivenFactors(system), control);
  if (progress) progress->throw_if_cancelled();
  if (!state.converged)
    throw Error(Code::check_failed, std::string(solver), fmt::format("has not converged after {} steps", state.steps),
                "a higher tolerance, conjugate_gradient or gmres");
  std::vector<double> radiosities(system.patches * system.bands);
  for (size_t k = 0; k < radiosities.size(); ++k)
    radiosities[k] = system.emissions[k] + system.reflectances[k] * state.irradiances[k];
  return radiosities;
}

}  // namespace aktina
