#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/radiosity/solve.h"
#include "aktina/radiosity/solver/hierarchy/hierarchy.h"
#include "radiosity/solver/hierarchy/surfaces.h"

namespace aktina {
namespace {

RadiosityState solve(const Surfaces& s, const RadiosityProblem& problem, std::string_view method,
                     const SolverControl& control) {
  return make_method(solvers(), "radiosity", method)->solve(problem, s.factors, control);
}

TEST(Hierarchical, ConvergesToTheMatrixSolution) {
  const Surfaces s(lit_room(true), 0.12);
  const std::vector<double> matrix = solve(s, s.problem, "matrix", {.tolerance = 1e-6}).irradiances;
  double last = 1;
  for (const double target : {0.1, 0.03, 0.01}) {
    const RadiosityState state = solve(s, s.problem, "hierarchical", {.tolerance = 1e-5, .target_error = target});
    EXPECT_TRUE(state.converged);
    const double error = difference(s.problem, state.irradiances, matrix);
    EXPECT_LT(error, 0.8 * last) << target;
    last = error;
  }
  EXPECT_LT(last, 0.05) << "most of it where the box stands on the floor";
}

TEST(Hierarchical, EachOracleComesNearItsTarget) {
  const Surfaces s(lit_room(false), 0.12);
  const std::vector<double> matrix = solve(s, s.problem, "matrix", {.tolerance = 1e-6}).irradiances;
  for (const char* method : {"hierarchical:oracle=0", "hierarchical:oracle=1", "hierarchical:oracle=2"}) {
    const RadiosityState state = solve(s, s.problem, method, {.tolerance = 1e-4, .target_error = 0.02});
    EXPECT_LT(difference(s.problem, state.irradiances, matrix), 0.08) << method << ", of which the lamp is most";
  }
}

TEST(Hierarchical, TellsWhatComesStraightFromEmitters) {
  const Surfaces s(lit_room(false), 0.2);
  const RadiosityState state = solve(s, s.problem, "hierarchical", {.tolerance = 1e-4, .target_error = 0.01});
  double direct = 0;
  for (size_t i = 0; i < s.problem.size(); ++i) direct += s.problem.areas[i] * state.direct[3 * i];
  EXPECT_NEAR(direct, 36, 0.4) << "all that the lamp sends";
}

TEST(Hierarchical, StoppedBeforeLightWasExchangedIsAResult) {
  const Surfaces s(lit_room(true), 0.2);
  for (const char* method : {"hierarchical", "clustering", "wavelet_m2"}) {
    Progress progress;
    progress.cancel();
    const RadiosityState state =
        solve(s, s.problem, method, {.tolerance = 1e-5, .target_error = 0.01, .progress = &progress});
    EXPECT_FALSE(state.converged) << method;
    EXPECT_EQ(state.irradiances.size(), 3 * s.problem.size()) << method;
  }
}

TEST(Hierarchical, TakesAnyNumberOfBands) {
  const Surfaces s(lit_room(false), 0.4);
  const SolverControl control{.tolerance = 1e-6, .target_error = 0.03};
  const RadiosityProblem one = s.green();
  const RadiosityState three = solve(s, s.problem, "hierarchical", control),
                       green = solve(s, one, "hierarchical", control);
  std::vector<double> second;
  for (size_t i = 0; i < one.size(); ++i) second.push_back(three.irradiances[3 * i + 1]);
  EXPECT_LT(difference(one, second, green.irradiances), 0.02);
}

TEST(Hierarchical, SameBytesForAnyNumberOfThreads) {
  const Surfaces s(lit_room(true), 0.2);
  const SolverControl control{.tolerance = 1e-3, .target_error = 0.02};
  set_thread_count(1);
  const RadiosityState one = solve(s, s.problem, "hierarchical", control);
  set_thread_count(2);
  const RadiosityState two = solve(s, s.problem, "hierarchical", control);
  set_thread_count(0);
  EXPECT_EQ(one.irradiances, two.irradiances);
}

TEST(Hierarchical, StopsWhenCancelledAndAccountsForEnergy) {
  const Surfaces s(lit_room(false), 0.3);
  Progress progress;
  SolverControl control{.tolerance = 1e-9, .progress = &progress, .each_step = {}};
  uint64_t steps = 0;
  control.each_step = [&](const RadiosityState& state) {
    EXPECT_EQ(state.steps, ++steps);
    EXPECT_NEAR(state.emitted, state.absorbed + state.escaped + unshot_flux(s.problem, state), 1e-9 * state.emitted);
    if (steps == 5) progress.cancel();
  };
  const RadiosityState state = solve(s, s.problem, "hierarchical", control);
  EXPECT_EQ(state.steps, 5U);
  EXPECT_FALSE(state.converged);
  EXPECT_GT(state.irradiances[0], 0);
}

TEST(Hierarchical, RefusesFactorsWithoutSurfaces) {
  const std::vector<double> f = {0, 1, 1, 0}, e = {1, 0}, rho = {0.5, 0.5};
  EXPECT_THAT(
      [&] {
        solve_radiosity_system({2, 1, f, e, rho}, "hierarchical");
      },
      testing::ThrowsMessage<Error>(testing::HasSubstr("ray_cast")));
}

TEST(Hierarchical, RefusesMoreFacesThanMemoryHasRoomForLinks) {
  Scene scene = room({1, 1, 1}, Rgb(0.5f), Rgb(10));
  Mesh& mesh = scene.meshes[0];
  mesh.positions.clear(), mesh.triangles.clear(), mesh.normals.clear(), mesh.uv[0].clear();
  for (uint32_t k = 0; k < 8000; ++k) {  // leaves of a tree
    const auto row = k / 90;
    const Point3 p(0.01f * float(k % 90), 0.01f * float(row), 0.5f);
    for (const Vec3 d : {Vec3(0), Vec3(0.005f, 0, 0), Vec3(0, 0, 0.005f)}) mesh.positions.push_back(p + d);
    mesh.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  const RadiosityOptions options{.solver = "wavelet_m2", .quality = "draft"};
  EXPECT_THAT([&] { solve_radiosity(scene, options); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("8005 faces")));
}

TEST(Hierarchical, DirectLightApartAgreesWithAllLightOnAllPatches) {
  RadiosityOptions options{.solver = "hierarchical", .patch_size = 0.1, .target_error = 0.005};
  const Solution apart = solve_radiosity(lit_room(true), options);
  options.solver = "matrix", options.indirect_size = 0, options.patch_size = 0.1;
  const Solution all = solve_radiosity(lit_room(true), options);
  std::vector<double> differences;
  for (size_t i = 0; i < all.irradiances.size(); ++i)
    if (all.irradiances[i].v.g > 0.1f)
      differences.push_back(double(std::abs(apart.irradiances[i].v.g / all.irradiances[i].v.g - 1)));
  std::sort(differences.begin(), differences.end());
  EXPECT_LT(differences[differences.size() / 2], 0.015);
}

}  // namespace
}  // namespace aktina
