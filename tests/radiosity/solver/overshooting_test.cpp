// What is shot in advance must not change where it ends, only how soon.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "aktina/radiosity/solve.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

/// A bright closed room with a lamp and a block, all light on all patches.
Solution solve_room(const std::string& solver, float reflectance, double tolerance) {
  Scene scene = room({3, 2.5f, 4}, Rgb(reflectance, 0.9f * reflectance, 0.8f * reflectance));
  add_quad(scene, {1, 2.4f, 1.5f}, {1, 0, 0}, {0, 0, 1}, Rgb(0), Rgb(100));
  add_box(scene, {0.5f, 0.2f, 1}, {0.8f, 1, 0.8f}, Rgb(reflectance));
  RadiosityOptions options{.solver = solver};
  options.patch_size = 0.5, options.indirect_size = 0, options.tolerance = tolerance;
  return solve_radiosity(scene, options);
}

/// Largest difference over the largest value.
double worst_difference(const Solution& a, const Solution& b) {
  float worst = 0, most = 0;
  for (size_t i = 0; i < a.irradiances.size(); ++i) {
    worst = std::max(worst, std::abs(a.irradiances[i].v.g - b.irradiances[i].v.g));
    most = std::max(most, b.irradiances[i].v.g);
  }
  return double(worst / most);
}

TEST(Overshooting, EndsWhereProgressiveRefinementDoes) {
  const Solution plain = solve_room("progressive", 0.7f, 1e-6), over = solve_room("overshooting", 0.7f, 1e-6);
  EXPECT_TRUE(over.converged);
  EXPECT_LT(worst_difference(over, plain), 1e-5);
}

TEST(Overshooting, TakesFewerShotsTheMoreTheBrighterTheRoom) {
  double saved_before = 1;
  for (const float reflectance : {0.3f, 0.6f, 0.9f}) {
    const Solution plain = solve_room("progressive", reflectance, 1e-3),
                   over = solve_room("overshooting", reflectance, 1e-3);
    const double saved = double(over.steps) / double(plain.steps);
    EXPECT_LT(saved, saved_before) << reflectance;
    saved_before = saved;
  }
  EXPECT_LT(saved_before, 0.6);
}

}  // namespace
}  // namespace aktina
