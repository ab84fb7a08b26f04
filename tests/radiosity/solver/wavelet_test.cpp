// Wavelet radiosity: all bases find the matrix solution; the claims about them.
#include "aktina/radiosity/solver/hierarchy/wavelet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/radiosity/solver/hierarchy/hierarchy.h"
#include "radiosity/solver/hierarchy/surfaces.h"

namespace aktina {
namespace {

RadiosityState solve(const Surfaces& s, std::string_view method, const SolverControl& control) {
  return make_method(solvers(), "radiosity", method)->solve(s.problem, s.factors, control);
}

class Wavelet : public testing::TestWithParam<const char*> {};

TEST_P(Wavelet, ConvergesToTheMatrixSolution) {
  const Surfaces s(lit_room(true), 0.15);
  const std::vector<double> matrix = solve(s, "matrix", {.tolerance = 1e-6}).irradiances;
  const auto error = [&](double target) {
    const RadiosityState state = solve(s, GetParam(), {.tolerance = 1e-4, .target_error = target});
    EXPECT_TRUE(state.converged);
    return difference(s.problem, state.irradiances, matrix);
  };
  const double rough = error(0.2), fine = error(0.02);
  EXPECT_LT(fine, 0.7 * rough);
  EXPECT_LT(fine, 0.06) << "most of it where the box stands on the floor, and beside the lamp";
}

TEST_P(Wavelet, SameBytesForAnyNumberOfThreads) {
  const Surfaces s(lit_room(true), 0.4);
  set_thread_count(1);
  const RadiosityState one = solve(s, GetParam(), {.target_error = 0.05});
  set_thread_count(2);
  const RadiosityState two = solve(s, GetParam(), {.target_error = 0.05});
  set_thread_count(0);
  EXPECT_EQ(one.irradiances, two.irradiances);
}

TEST_P(Wavelet, StopsWhenCancelled) {
  const Surfaces s(lit_room(false), 0.5);
  Progress progress;
  SolverControl control{.tolerance = 1e-9, .progress = &progress, .each_step = {}};
  control.each_step = [&](const RadiosityState&) { progress.cancel(); };
  const RadiosityState state = solve(s, GetParam(), control);
  EXPECT_EQ(state.steps, 1U);
  EXPECT_FALSE(state.converged);
}

INSTANTIATE_TEST_SUITE_P(Radiosity, Wavelet, testing::Values("wavelet_haar", "wavelet_m2", "wavelet_m3", "wavelet_f2"),
                         [](const auto& each) { return std::string(each.param); });

/// Furnace: the coefficients of a closed room carry each function of the emitted light where it belongs.
TEST(WaveletRadiosity, UniformLightStaysUniform) {
  for (const char* method : {"wavelet_haar", "wavelet_m2", "wavelet_m3", "wavelet_f2"}) {
    const Surfaces s(room({3, 2, 2.5f}, Rgb(0.5f), Rgb(10)), 0.5);
    const RadiosityState state = solve(s, method, {.tolerance = 1e-4, .target_error = 0.01});
    const std::vector<double> expected(state.irradiances.size(), 20);
    EXPECT_LT(difference(s.problem, state.irradiances, expected), 0.012) << method;
  }
}

/// Inside of a tetrahedron: triangles only, patches that fit no quarter of theirs.
TEST(WaveletRadiosity, TrianglesShareTheirLightLikeQuadrilaterals) {
  Scene scene = room({1, 1, 1}, Rgb(0.5f), Rgb(10));
  scene.instances.resize(1), scene.meshes.resize(1);
  Mesh& mesh = scene.meshes[0];
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  mesh.normals.clear(), mesh.uv[0].clear();
  const Surfaces s(std::move(scene), 0.3);
  for (const char* method : {"hierarchical", "wavelet_haar", "wavelet_m2", "wavelet_m3", "wavelet_f2"}) {
    const RadiosityState state = solve(s, method, {.tolerance = 1e-4, .target_error = 0.01});
    const std::vector<double> expected(state.irradiances.size(), 20);
    EXPECT_LT(difference(s.problem, state.irradiances, expected), 0.03) << method;
    EXPECT_NEAR(state.escaped, 0, 0.01 * state.emitted) << method;
  }
}

double links(const Surfaces& s, const Basis& basis, double most) {
  LinkedTree h(s.problem, s.surfaces, {.basis = basis, .spread = Transport::Spread::interpolation, .most = most}, 0);
  h.link(4, nullptr), h.exchange(), h.link(1, nullptr);
  return double(h.links().size());
}

TEST(WaveletRadiosity, VanishingMomentsSaveLinksWhereNothingIsInTheWay) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {0, 0, 2}, {2, 0, 0}, Rgb(0.5f), Rgb(10));
  add_quad(scene, {0, 1, 0}, {2, 0, 0}, {0, 0, 2}, Rgb(0.5f), Rgb(10));
  const Surfaces s(std::move(scene), 0.05);
  const double haar = links(s, Basis::polynomials(1), 1e-5), m2 = links(s, Basis::polynomials(2), 1e-5),
               m3 = links(s, Basis::polynomials(3), 1e-5);
  EXPECT_LT(m2, haar / 3);
  EXPECT_LT(m3, m2);
}

TEST(Transport, CoefficientsAcrossASharedEdgeAreRight) {
  // The mean of all of the transport between perpendicular unit squares is their form factor.
  const TreePatch floor{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, false, 1};
  const TreePatch wall{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, false, 1};
  for (int order = 1; order <= 3; ++order) {
    const Basis basis = Basis::polynomials(order);
    Transport::Coefficients t;
    Transport(basis, Transport::Spread::interpolation).sample_near(floor, wall, t.data());
    EXPECT_NEAR(t[0], 0.200043776075, 2e-3) << order;
  }
}

TEST(Transport, AllBasesHaveTheSameMeans) {
  const TreePatch triangle{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, true, 0.5};
  const TreePatch above{{0, 2, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, false, 1};
  const auto mean = [&](const Basis& basis) {
    return double(Transport(basis, Transport::Spread::interpolation).sample(triangle, above, nullptr).factor);
  };
  const double fine = mean(Basis::polynomials(3));
  EXPECT_NEAR(mean(Basis::polynomials(1)), fine, 1e-2 * fine);
  EXPECT_NEAR(mean(Basis::polynomials(2)), fine, 1e-2 * fine);
  EXPECT_NEAR(mean(Basis::flatlets()), fine, 2e-2 * fine);
}

}  // namespace
}  // namespace aktina
