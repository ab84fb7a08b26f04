// Stochastic Jacobi iteration on factors that are known exactly: an integrating sphere, where F_ij is the share of j in
// the whole area, so that the irradiance is the same everywhere.
#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/radiosity/solver/matrix_rays.h"
#include "aktina/radiosity/solver/solver.h"

namespace aktina {
namespace {

struct Sphere final : FactorSource {
  RadiosityProblem problem;

  /// @param smallest  area of every fifth receiver, against the others
  explicit Sphere(size_t receivers, double smallest = 1) {
    problem.bands = 2;
    problem.weights = {1, 1};
    double sum = 0;
    for (size_t i = 0; i < receivers; ++i) {
      problem.areas.push_back(i % 5 == 1 ? smallest : 1);
      sum += problem.areas.back();
      const bool bright = i % 3 == 0;
      problem.reflectances.insert(problem.reflectances.end(), {bright ? 0.8 : 0.2, 0.5});
      problem.emissions.insert(problem.emissions.end(), {i % 2 * 10.0, i % 2 * 5.0});
    }
    for (double& area : problem.areas) area /= sum;
    problem.shoot_one_by_one();
  }
  void column(size_t shooter, std::span<double> factors) const override {
    std::fill(factors.begin(), factors.end(), problem.areas[shooter]);
  }
  double irradiance(size_t band) const {
    double e = 0, rho = 0;
    for (size_t s = 0; s < problem.size(); ++s) {
      e += problem.areas[s] * problem.emissions[s * 2 + band];
      rho += problem.areas[s] * problem.reflectances[s * 2 + band];
    }
    return e / (1 - rho);
  }
  RadiosityState solve(const SolverControl& control) const {
    return make_method(solvers(), "radiosity", "stochastic_jacobi")->solve(problem, *this, control);
  }
  /// Root of the mean square of relative errors.
  double error(const RadiosityState& state) const {
    double sum = 0;
    for (size_t k = 0; k < state.irradiances.size(); ++k)
      sum += std::pow(state.irradiances[k] / irradiance(k % 2) - 1, 2);
    return std::sqrt(sum / double(state.irradiances.size()));
  }
};

TEST(StochasticJacobi, ErrorsAreWhatWasAskedForAndFallWithIt) {
  const Sphere sphere(200);
  double last = 1;
  for (const double target : {0.08, 0.02, 0.005}) {
    double error = 0;
    for (uint32_t seed = 0; seed < 4; ++seed)
      error += sphere.error(sphere.solve({.tolerance = 1e-4, .target_error = target, .seed = seed})) / 4;
    EXPECT_LT(error, 2 * target);
    EXPECT_LT(error, 0.7 * last);
    last = error;
  }
}

TEST(StochasticJacobi, SmallReceiversAreNotForgotten) {
  const Sphere sphere(200, 1e-4);
  const RadiosityState state = sphere.solve({.tolerance = 1e-4, .target_error = 0.01});
  for (size_t s = 1; s < 200; s += 5)
    for (size_t b = 0; b < 2; ++b)
      EXPECT_NEAR(state.irradiances[2 * s + b], sphere.irradiance(b), 0.25 * sphere.irradiance(b))
          << "hardly a ray arrives there";
}

TEST(StochasticJacobi, IsRightOnTheAverage) {
  const Sphere sphere(50);
  double mean = 0;
  constexpr uint32_t kRuns = 200;
  for (uint32_t seed = 0; seed < kRuns; ++seed) {
    const RadiosityState state = sphere.solve({.tolerance = 1e-6, .target_error = 0.1, .seed = seed});
    for (size_t s = 0; s < 50; ++s) mean += state.irradiances[2 * s] / (50 * kRuns * sphere.irradiance(0));
  }
  EXPECT_NEAR(mean, 1, 0.01);
}

TEST(StochasticJacobi, TellsDirectLightAndAccountsForEnergy) {
  const Sphere sphere(100);
  const RadiosityState state = sphere.solve({.tolerance = 1e-3, .target_error = 0.01});
  EXPECT_TRUE(state.converged);
  for (size_t s = 0; s < 100; ++s) EXPECT_NEAR(state.direct[2 * s], 5, 0.3);
  EXPECT_NEAR(state.escaped, 0, 0.01 * state.emitted) << "a closed scene loses nothing";
  EXPECT_NEAR(state.emitted, state.absorbed + state.escaped + unshot_flux(sphere.problem, state), 1e-9 * state.emitted);
}

TEST(StochasticJacobi, SameBytesForAnyNumberOfThreads) {
  const Sphere sphere(1000);
  set_thread_count(1);
  const RadiosityState one = sphere.solve({.tolerance = 1e-3});
  set_thread_count(2);
  const RadiosityState two = sphere.solve({.tolerance = 1e-3});
  set_thread_count(0);
  EXPECT_EQ(one.irradiances, two.irradiances);
}

TEST(StochasticJacobi, StopsWhenCancelledAndKeepsWhatItHas) {
  const Sphere sphere(50);
  Progress progress;
  SolverControl control{.tolerance = 1e-9, .progress = &progress, .each_step = {}};
  control.each_step = [&](const RadiosityState&) { progress.cancel(); };
  const RadiosityState state = sphere.solve(control);
  EXPECT_EQ(state.steps, 1U);
  EXPECT_FALSE(state.converged);
  EXPECT_GT(state.irradiances[1], 0);
}

TEST(MatrixRays, ArriveAsTheFactorsSay) {
  RadiosityProblem problem;
  problem.bands = 1, problem.weights = {1};
  problem.areas = {1, 3, 2}, problem.reflectances = {0, 0, 0}, problem.emissions = {1, 0, 0};
  problem.shooters = {{0, 1}, {1, 2}};
  struct Factors final : FactorSource {
    void column(size_t shooter, std::span<double> factors) const override {
      std::fill(factors.begin(), factors.end(), shooter == 0 ? 0.25 : 0.5);
    }
  } factors;
  SolverControl control;
  control.seed = 3;
  const MatrixRays rays(problem, factors, control);
  std::vector<LightRays::Ray> sent;
  for (uint32_t k = 0; k < 4096; ++k) sent.push_back({2, k});
  std::vector<LightRays::Arrival> arrivals;
  rays.follow(sent, arrivals);
  double counts[3] = {};
  for (const LightRays::Arrival& a : arrivals) counts[a.receiver] += 1.0 / 4096;
  EXPECT_NEAR(counts[0], 0.25, 0.01);
  EXPECT_NEAR(counts[1], 0.3, 0.01) << "members by their areas";
  EXPECT_NEAR(counts[2], 0.2, 0.01);
}

}  // namespace
}  // namespace aktina
