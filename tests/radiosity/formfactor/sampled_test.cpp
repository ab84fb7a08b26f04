// The methods that sample: they converge to the exact one at their rates, depend on nothing but seed and row, and say
// how wrong they are.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include "aktina/base/parallel.h"
#include "aktina/radiosity/formfactor/matrix.h"
#include "polygons.h"

namespace aktina {
namespace {

/// A floor and a ceiling that a screen hides partly.
FormFactorScene room() {
  return {{unit_square(), ceiling(1)}, {{{{0.1, 0.3, 0.3}, {0.5, 0.3, 0.3}, {0.5, 0.9, 0.3}, {0.1, 0.9, 0.3}}}}};
}
double exact() {
  static const double f = form_factor_matrix(room(), "contour").factors[1];
  return f;
}

/// Root of the mean squared error over seeds.
double rms(const std::string& method) {
  double sum = 0;
  constexpr int kSeeds = 16;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const double f = form_factor_matrix(room(), method + ",seed=" + std::to_string(seed)).factors[1];
    sum += (f - exact()) * (f - exact());
  }
  return std::sqrt(sum / kSeeds);
}

TEST(MonteCarlo, ErrorFallsAtLeastAsTheRootOfTheSamplesAndIsNoLargerThanItSays) {
  const double few = rms("monte_carlo:samples=1024"), many = rms("monte_carlo:samples=16384");
  EXPECT_GT(few / many, 3) << "plain random samples: 4; stratified ones: more";
  const double stated = form_factor_matrix(room(), "monte_carlo:samples=1024").errors[1];
  EXPECT_NEAR(stated, std::sqrt(exact() * (1 - exact()) / 1024), 0.1 * stated);
  EXPECT_LT(few, 1.5 * stated);
}

TEST(MonteCarlo, AClosedRoomCatchesEveryRay) {
  const FormFactorMatrix f = form_factor_matrix({box(1, 1.5, 0.8), {}}, "monte_carlo:samples=4096");
  for (size_t i = 0; i < 6; ++i) {
    double sum = 0;
    for (size_t j = 0; j < 6; ++j) sum += f.factors[i * 6 + j];
    EXPECT_NEAR(sum, 1, 1e-3) << "a ray may slip through between walls where edges meet, one in thousands";
    EXPECT_EQ(f.factors[i * 6 + i], 0);
  }
}

TEST(RayCast, ErrorFallsAtLeastAsTheRootOfTheSamplesAndIsNoLargerThanItSays) {
  const double few = rms("ray_cast:points=16,samples=4"), many = rms("ray_cast:points=256,samples=4");
  EXPECT_GT(few / many, 3);
  const double stated = form_factor_matrix(room(), "ray_cast:points=16,samples=4").errors[1];
  EXPECT_LT(few, 1.5 * stated);
}

TEST(RayCast, APointThatNothingHidesIsExact) {
  const auto method = make_method(formfactors(), "formfactor", "ray_cast");
  method->build({{ceiling(1)}, {}});
  EXPECT_NEAR(method->row({0.5, 0.5, 0}, {0, 0, 1}).factors[0], 0.239456470461, 1e-12);
  EXPECT_EQ(method->row({0.5, 0.5, 2}, {0, 0, 1}).factors[0], 0);
}

TEST(Hemisphere, CellsOfEqualAreaCatchAllOfAClosedRoom) {
  const FormFactorMatrix f = form_factor_matrix({box(1, 1.5, 0.8), {}}, "hemisphere:points=16");
  expect_closed(f, 6, 1e-3);
}

TEST(CubicTetrahedron, DeltaFormFactorsConvergeToTheClosedForm) {
  const auto error = [](int resolution) {
    const std::string method = fmt::format("cubic_tetrahedron:points=64,resolution={}", resolution);
    const auto estimator = make_method(formfactors(), "formfactor", method);
    estimator->build({{ceiling(1)}, {}});
    return std::abs(estimator->row({0.5, 0.5, 0}, {0, 0, 1}).factors[0] - 0.239456470461);
  };
  EXPECT_LT(error(16), 1e-2);
  EXPECT_LT(error(64), 1e-3) << "second order: cells a fourth as wide";
}

TEST(SinglePlane, LeavesOutWhatIsLow) {
  // From a point in a closed room a plane sees the solid angle above its edges: 4 / pi atan-terms of a square.
  const auto seen = [](double extent) {
    const auto estimator =
        make_method(formfactors(), "formfactor", fmt::format("single_plane:resolution=256,extent={}", extent));
    estimator->build({box(1, 1, 1), {}});
    double sum = 0;
    for (const double f : estimator->row({0.5, 0.5, 1e-6}, {0, 0, 1}).factors) sum += f;
    return sum;
  };
  for (const double w : {1.0, 4.0}) {
    const double share = 4 / kPi * w / std::sqrt(1 + w * w) * std::atan(w / std::sqrt(1 + w * w));
    EXPECT_NEAR(seen(w), share, 2e-3) << w;
  }
}

TEST(Hybrid, MeetsItsTargetPastOccluders) {
  for (const double target : {1e-3, 1e-5}) {
    const FormFactorMatrix f = form_factor_matrix(room(), fmt::format("hybrid:target_error={}", target));
    EXPECT_NEAR(f.factors[1], exact(), target);
    EXPECT_LE(f.errors[1], target);
  }
}

class EverySampledMethod : public testing::TestWithParam<std::string> {};

TEST_P(EverySampledMethod, GivesTheSameForAnyNumberOfThreads) {
  FormFactorScene scene{box(1, 1.5, 0.8), room().occluders};
  set_thread_count(1);
  const FormFactorMatrix one = form_factor_matrix(scene, GetParam());
  set_thread_count(3);
  const FormFactorMatrix three = form_factor_matrix(scene, GetParam());
  set_thread_count(0);
  EXPECT_EQ(one.factors, three.factors);
  EXPECT_EQ(one.errors, three.errors);
}

TEST_P(EverySampledMethod, ScaleDoesNotMatter) {
  for (const double scale : {1e-6, 1e6}) {
    FormFactorScene scene = room();
    for (Polygon& p : scene.surfaces) p = moved(p, {0, 0, 0}, scale);
    for (Polygon& p : scene.occluders) p = moved(p, {0, 0, 0}, scale);
    EXPECT_NEAR(form_factor_matrix(scene, GetParam()).factors[1], exact(), 0.01) << scale;
  }
}

TEST_P(EverySampledMethod, ARowFromAPointAgreesWithTheExactOne) {
  const auto method = make_method(formfactors(), "formfactor", GetParam());
  const auto reference = make_method(formfactors(), "formfactor", "contour");
  method->build(room()), reference->build(room());
  const Point3d x(0.3, 0.4, 0);
  EXPECT_NEAR(method->row(x, {0, 0, 1}).factors[1], reference->row(x, {0, 0, 1}).factors[1], 0.01);
}

INSTANTIATE_TEST_SUITE_P(FormFactors, EverySampledMethod,
                         testing::Values("ray_cast", "hemicube:resolution=128,hemicubes=16", "monte_carlo",
                                         "hemisphere", "single_plane:points=64,extent=12", "cubic_tetrahedron",
                                         "hybrid"));

}  // namespace
}  // namespace aktina
