// What every solver must give on factors that are known exactly, and what progressive refinement keeps at every step.
#include "aktina/radiosity/solver/solver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/base/random.h"

namespace aktina {
namespace {

/// A closed enclosure of patches with reciprocity and rows that sum to 1: patches of an integrating sphere, F_ij = A_j.
struct Sphere final : FactorSource {
  RadiosityProblem problem;

  Sphere(size_t patches, size_t bands, uint32_t seed, uint32_t members = 1) {
    Pcg32 random(seed);
    problem.bands = bands;
    problem.weights.assign(bands, 1);
    double sum = 0;
    for (size_t i = 0; i < patches; ++i) {
      problem.areas.push_back(0.1 + random.uniform_double());
      sum += problem.areas.back();
      for (size_t b = 0; b < bands; ++b) {
        problem.reflectances.push_back(0.9 * random.uniform_double());
        problem.emissions.push_back(i % 7 == 0 ? 10 * random.uniform_double() : 0);
      }
    }
    for (double& area : problem.areas) area /= sum;
    for (uint32_t i = 0; i < patches; i += members)
      problem.shooters.push_back({i, std::min(members, uint32_t(patches) - i)});
  }
  void column(size_t shooter, std::span<double> factors) const override {
    double area = 0;
    const auto range = problem.shooters[shooter];
    for (size_t s = range.first; s < range.first + range.count; ++s) area += problem.areas[s];
    std::fill(factors.begin(), factors.end(), area);
  }
  /// H is the same everywhere: <E> / (1 - <rho>), area means.
  double irradiance(size_t band) const {
    double e = 0, rho = 0;
    for (size_t s = 0; s < problem.size(); ++s) {
      e += problem.areas[s] * problem.emissions[s * problem.bands + band];
      rho += problem.areas[s] * problem.reflectances[s * problem.bands + band];
    }
    return e / (1 - rho);
  }
};

RadiosityState solve(const Sphere& sphere, std::string_view method, const SolverControl& control) {
  return make_method(solvers(), "radiosity", method)->solve(sphere.problem, sphere, control);
}

class EverySolver : public testing::TestWithParam<std::string> {};

TEST_P(EverySolver, FindsTheClosedFormOfAnIntegratingSphere) {
  for (const uint32_t members : {1U, 4U}) {
    const Sphere sphere(41, 3, 5, members);
    const RadiosityState state = solve(sphere, GetParam(), {.tolerance = 1e-13});
    EXPECT_TRUE(state.converged);
    for (size_t s = 0; s < sphere.problem.size(); ++s)
      for (size_t b = 0; b < 3; ++b)
        EXPECT_NEAR(state.irradiances[s * 3 + b], sphere.irradiance(b), 1e-10 * sphere.irradiance(b)) << members;
  }
}

TEST_P(EverySolver, AccountsForAllEnergy) {
  const Sphere sphere(60, 3, 9, 3);
  const RadiosityState state = solve(sphere, GetParam(), {.tolerance = 1e-4});
  EXPECT_NEAR(state.emitted, state.absorbed + state.escaped + unshot_flux(sphere.problem, state),
              1e-12 * state.emitted);
  EXPECT_NEAR(state.escaped, 0, 1e-12 * state.emitted) << "a closed scene loses nothing";
}

TEST_P(EverySolver, LightOfLampsCountsAsDirectAndIsReflected) {
  Sphere sphere(20, 1, 3);
  std::fill(sphere.problem.emissions.begin(), sphere.problem.emissions.end(), 0.0);
  sphere.problem.arriving.assign(20, 0);
  sphere.problem.arriving[4] = 100;
  const RadiosityState state = solve(sphere, GetParam(), {.tolerance = 1e-13});
  double rho = 0;
  for (size_t s = 0; s < 20; ++s) rho += sphere.problem.areas[s] * sphere.problem.reflectances[s];
  const double first = sphere.problem.areas[4] * sphere.problem.reflectances[4] * 100;
  for (size_t s = 0; s < 20; ++s) {
    const double direct = s == 4 ? 100 : 0;
    EXPECT_NEAR(state.irradiances[s], direct + first / (1 - rho), 1e-9);
    EXPECT_EQ(state.direct[s], direct);
  }
}

TEST_P(EverySolver, SameBytesForAnyNumberOfThreads) {
  const Sphere sphere(1000, 3, 12);
  set_thread_count(1);
  const RadiosityState one = solve(sphere, GetParam(), {.tolerance = 1e-3});
  set_thread_count(2);
  const RadiosityState two = solve(sphere, GetParam(), {.tolerance = 1e-3});
  set_thread_count(0);
  EXPECT_EQ(one.irradiances, two.irradiances);
  EXPECT_EQ(one.escaped, two.escaped);
}

TEST_P(EverySolver, StopsWhenCancelledAndKeepsWhatItHas) {
  const Sphere sphere(50, 1, 2);
  Progress progress;
  SolverControl control{.tolerance = 1e-13, .progress = &progress, .each_step = {}};
  control.each_step = [&](const RadiosityState&) { progress.cancel(); };
  const RadiosityState state = solve(sphere, GetParam(), control);
  const bool at_once = GetParam() == "gmres" || GetParam() == "conjugate_gradient";  // one direction is all there is
  EXPECT_EQ(state.steps, 1U);
  EXPECT_EQ(state.converged, at_once);
  EXPECT_GT(state.irradiances[1], 0);
}

INSTANTIATE_TEST_SUITE_P(Radiosity, EverySolver,
                         testing::Values("progressive", "overshooting", "substructured", "matrix", "jacobi",
                                         "overrelaxed", "southwell", "conjugate_gradient", "gmres"),
                         [](const auto& each) { return each.param; });

TEST(Progressive, KeepsItsInvariantsAtEveryStep) {
  const Sphere sphere(30, 1, 8);
  const RadiosityProblem& p = sphere.problem;
  std::vector<double> before(30, 0);
  double unshot_before = 1.0001;
  SolverControl control{.tolerance = 1e-6, .each_step = {}};
  control.each_step = [&](const RadiosityState& state) {
    EXPECT_LT(state.unshot_share, unshot_before) << "total unshot power decreases strictly";
    unshot_before = state.unshot_share;
    EXPECT_NEAR(state.emitted, state.absorbed + state.escaped + unshot_flux(p, state), 1e-12 * state.emitted);
    for (size_t i = 0; i < 30; ++i) {
      // E - (I - rho F) B = rho F dB
      double gathered = 0, waiting = 0;
      for (size_t j = 0; j < 30; ++j) {
        gathered += p.areas[j] * state.radiosity(p, j, 0);
        waiting += p.areas[j] * state.unshot[j];
      }
      const double b = state.radiosity(p, i, 0);
      EXPECT_NEAR(p.emissions[i] - b + p.reflectances[i] * gathered, p.reflectances[i] * waiting, 1e-12);
      EXPECT_GE(b, before[i]) << "every radiosity grows";
      EXPECT_LE(b, p.emissions[i] + p.reflectances[i] * sphere.irradiance(0) * (1 + 1e-12));
      before[i] = b;
    }
  };
  solve(sphere, "progressive", control);
}

TEST(Progressive, AFewStepsGiveMostOfTheLight) {
  const Sphere sphere(70, 1, 21);
  const auto error_after = [&](uint64_t steps) {
    const RadiosityState state = solve(sphere, "progressive", {.tolerance = 0, .most_steps = steps});
    return 1 - state.irradiances[3] / sphere.irradiance(0);
  };
  EXPECT_LT(error_after(40), 0.5 * error_after(10));
  EXPECT_LT(error_after(400), 1e-3);
}

TEST(SolveRadiositySystem, RefusesWhatHasNoFiniteSolution) {
  const std::vector<double> f = {0, 1, 1, 0}, e = {1, 0}, rho = {0.5, 1};
  EXPECT_THAT(
      [&] {
        solve_radiosity_system({2, 1, f, e, rho});
      },
      testing::ThrowsMessage<Error>(testing::HasSubstr("no finite solution")));
  const std::vector<double> nan = {NAN, 0};
  EXPECT_THROW(solve_radiosity_system({2, 1, f, nan, e}), Error);
}

}  // namespace
}  // namespace aktina
