// What sets the matrix solvers apart: how many sweeps they take on the same system.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/random.h"
#include "aktina/radiosity/solver/factor_matrix.h"
#include "aktina/radiosity/solver/solver.h"

namespace aktina {
namespace {

/// A closed enclosure with random exchange areas; factors keep reciprocity and rows sum to 1.
struct Enclosure final : FactorSource {
  static constexpr size_t kPatches = 60;
  RadiosityProblem problem;
  std::vector<double> factors = std::vector<double>(kPatches * kPatches);

  explicit Enclosure(double reflectance, double spread = 0) {
    Pcg32 random(11);
    for (size_t i = 0; i < kPatches; ++i)
      for (size_t j = 0; j <= i; ++j)
        factors[i * kPatches + j] = factors[j * kPatches + i] = std::pow(random.uniform_double(), 8);
    for (int round = 0; round < 300; ++round) scale_rows();
    problem.bands = 1, problem.weights = {1};
    problem.areas.assign(kPatches, 1);
    for (size_t i = 0; i < kPatches; ++i) {
      problem.reflectances.push_back(reflectance + spread * (random.uniform_double() - 0.5));
      problem.emissions.push_back(i < 3 ? 100 : 0);
    }
    problem.shoot_one_by_one();
  }
  void column(size_t shooter, std::span<double> column) const override {
    for (size_t s = 0; s < kPatches; ++s) column[s] = factors[s * kPatches + shooter];
  }
  uint64_t sweeps(std::string_view solver, double tolerance = 1e-8) const {
    const RadiosityState state =
        make_method(solvers(), "radiosity", solver)->solve(problem, *this, {.tolerance = tolerance});
    EXPECT_TRUE(state.converged) << solver;
    return state.steps;
  }

 private:
  void scale_rows() {
    std::vector<double> scales;
    for (size_t i = 0; i < kPatches; ++i) {
      double sum = 0;
      for (size_t j = 0; j < kPatches; ++j) sum += factors[i * kPatches + j];
      scales.push_back(1 / std::sqrt(sum));
    }
    for (size_t i = 0; i < kPatches; ++i)
      for (size_t j = 0; j < kPatches; ++j) factors[i * kPatches + j] *= scales[i] * scales[j];
  }
};

TEST(MatrixSolvers, GaussSeidelTakesAboutHalfTheSweepsOfJacobi) {
  const Enclosure enclosure(0.8);
  const double ratio = double(enclosure.sweeps("matrix")) / double(enclosure.sweeps("jacobi"));
  EXPECT_GT(ratio, 0.4);
  EXPECT_LT(ratio, 0.7);
}

TEST(MatrixSolvers, JacobiErrorsShrinkByTheReflectance) {
  const Enclosure enclosure(0.8);
  const auto few = double(enclosure.sweeps("jacobi", 1e-4)), many = double(enclosure.sweeps("jacobi", 1e-8));
  EXPECT_NEAR(many - few, std::log(1e-4) / std::log(0.8), 1.5) << "all rows sum to 0.8";
}

TEST(MatrixSolvers, OverrelaxationSavesSweepsInBrightRooms) {
  const Enclosure enclosure(0.95);
  EXPECT_LT(enclosure.sweeps("overrelaxed"), 0.9 * double(enclosure.sweeps("matrix")));
  EXPECT_EQ(enclosure.sweeps("overrelaxed:factor=1"), enclosure.sweeps("matrix"));
}

TEST(MatrixSolvers, KrylovMethodsHardlyMindBrightRooms) {
  const Enclosure dim(0.5, 0.2), bright(0.97, 0.05);
  for (const char* solver : {"conjugate_gradient", "gmres"}) {
    EXPECT_LT(bright.sweeps(solver), 40U) << solver;
    EXPECT_LT(bright.sweeps(solver), double(bright.sweeps("matrix")) / 3) << solver;
    EXPECT_LE(dim.sweeps(solver), dim.sweeps("matrix") + 6) << solver;
  }
}

TEST(MatrixSolvers, GmresEndsWithinAsManyStepsAsThereArePatches) {
  const Enclosure enclosure(0.97, 0.05);
  EXPECT_LE(enclosure.sweeps("gmres:restart=200", 1e-10), Enclosure::kPatches);
  EXPECT_GE(enclosure.sweeps("gmres:restart=4", 1e-10), enclosure.sweeps("gmres:restart=200", 1e-10));
}

TEST(MatrixSolvers, SouthwellTakesFewerSweepsThanGaussSeidel) {
  const Enclosure enclosure(0.8, 0.4);
  EXPECT_LE(enclosure.sweeps("southwell"), enclosure.sweeps("matrix"));
}

TEST(MatrixSolvers, ConjugateGradientsSolveFactorsThatAreNotQuiteReciprocal) {
  Enclosure enclosure(0.8, 0.3);
  Pcg32 random(5);
  for (double& f : enclosure.factors) f *= 1 + 0.05 * (random.uniform_double() - 0.5);  // as rays leave them
  const auto solve = [&](std::string_view solver) {
    return make_method(solvers(), "radiosity", solver)->solve(enclosure.problem, enclosure, {.tolerance = 1e-10});
  };
  const RadiosityState direct = solve("matrix"), state = solve("conjugate_gradient");
  EXPECT_TRUE(state.converged);
  for (size_t s = 0; s < Enclosure::kPatches; ++s)
    EXPECT_NEAR(state.irradiances[s], direct.irradiances[s], 1e-8 * direct.irradiances[s]);
}

}  // namespace
}  // namespace aktina
