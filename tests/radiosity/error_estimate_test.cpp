// Estimated errors against those that a finer solution shows.
#include "aktina/radiosity/error_estimate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/radiosity/solve.h"
#include "aktina/radiosity/solver/reconstruct.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

TEST(PatchErrors, OfALinearFieldAreExact) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {2, 0, 0}, {0, 0, -1}, Rgb(0.5f));
  scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, Irradiance(Rgb(7))}, -1});
  Solution s = solve_radiosity(scene, {.patch_size = 0.25});
  for (const float e : patch_errors(s)) EXPECT_NEAR(e, 0, 1e-5f) << "constant light";
  EXPECT_NEAR(relative_error(s), 0, 1e-6);
  for (size_t i = 0; i < s.mesh.size(); ++i) {
    const auto& c = s.mesh.patches[i];
    s.irradiances[i].v = Rgb(20 + 3 * 0.5f * (s.mesh.positions[c[0]].x + s.mesh.positions[c[2]].x));
  }
  reconstruct_vertices(s);
  const double exact = 3 * 0.25 / std::sqrt(12.0);  // slope times width, as a uniform distribution has it
  for (const float e : patch_errors(s)) EXPECT_NEAR(e, exact, 1e-4);
  EXPECT_NEAR(relative_error(s), exact / 23, 1e-5);
}

struct Boxed {
  Bounds box;
  double square = 0, area = 0;
};

/// By patch of `coarse`: RMS difference between its value and those of the patches of `fine` in it.
std::vector<double> true_errors(const Solution& coarse, const Solution& fine) {
  std::vector<Boxed> patches(coarse.mesh.size());
  for (size_t i = 0; i < patches.size(); ++i)
    for (const uint32_t v : coarse.mesh.patches[i]) patches[i].box.add(coarse.mesh.positions[v]);
  for (size_t f = 0; f < fine.mesh.size(); ++f) {
    Point3 p(0);
    for (const uint32_t v : fine.mesh.patches[f]) p += 0.25f * fine.mesh.positions[v];
    for (size_t i = 0; i < patches.size(); ++i) {
      const Bounds& b = patches[i].box;
      if (coarse.mesh.centres[i].instance != fine.mesh.centres[f].instance) continue;
      if (!glm::all(glm::greaterThanEqual(p, b.low - 1e-4f)) || !glm::all(glm::lessThanEqual(p, b.high + 1e-4f)))
        continue;
      const double off = double(luminance(fine.irradiances[f].v - coarse.irradiances[i].v));
      patches[i].square += double(fine.mesh.areas[f]) * off * off, patches[i].area += double(fine.mesh.areas[f]);
      break;
    }
  }
  std::vector<double> errors;
  for (const Boxed& b : patches) errors.push_back(b.area > 0 ? std::sqrt(b.square / b.area) : 0);
  return errors;
}

TEST(PatchErrors, FollowThoseAgainstAFinerSolution) {
  Scene scene = room({2, 2, 2}, Rgb(0.6f, 0.5f, 0.4f));
  add_quad(scene, {0.75f, 1.9f, 0.75f}, {0.5f, 0, 0}, {0, 0, 0.5f}, Rgb(0), Rgb(100));
  add_box(scene, {0.5f, 0.25f, 0.5f}, {0.5f, 0.5f, 0.5f}, Rgb(0.7f));
  const RadiosityOptions fine{.quality = "fine", .patch_size = 0.03125, .indirect_size = 4};
  const Solution exact = solve_radiosity(scene, fine);
  for (const double size : {0.25, 0.125}) {
    const Solution s = solve_radiosity(scene, {.quality = "fine", .patch_size = size, .indirect_size = 0.125 / size});
    const std::vector<float> estimated = patch_errors(s);
    const std::vector<double> truth = true_errors(s, exact);
    double xx = 0, yy = 0, xy = 0;
    size_t within = 0, counted = 0;
    for (size_t i = 0; i < truth.size(); ++i) {
      const double a = double(s.mesh.areas[i]), x = double(estimated[i]);
      xx += a * x * x, yy += a * truth[i] * truth[i], xy += a * x * truth[i];
      if (truth[i] < 0.1) continue;  // lx; noise
      ++counted, within += x > 0.5 * truth[i] && x < 2 * truth[i];
    }
    EXPECT_GT(xy / std::sqrt(xx * yy), 0.9) << "correlation";
    EXPECT_GT(std::sqrt(xx / yy), 0.75) << "all in all, at " << size;
    EXPECT_LT(std::sqrt(xx / yy), 1.25) << "all in all, at " << size;
    EXPECT_GT(double(within), 0.8 * double(counted)) << "within a factor of two";
  }
}

}  // namespace
}  // namespace aktina
