// Solvers on trees against path tracing, which knows no patches.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "aktina/radiosity/solve.h"
#include "aktina/trace/illuminance.h"
#include "radiosity/solver/hierarchy/surfaces.h"

namespace aktina {
namespace {

TEST(SolversOnTrees, AgreeWithPathTracing) {
  const Scene scene = lit_room(true);
  RadiosityOptions options{.patch_size = 0.1, .target_error = 0.01};
  std::vector<float> traced;
  std::vector<size_t> patches;
  for (const char* solver : {"hierarchical", "clustering", "wavelet_haar", "wavelet_m2", "wavelet_m3", "wavelet_f2"}) {
    options.solver = solver;
    const Solution s = solve_radiosity(scene, options);
    if (traced.empty()) {
      std::vector<Point3> points;
      std::vector<Vec3> normals;
      for (size_t i = 5; i < s.mesh.size(); i += 23) {
        const auto& c = s.mesh.patches[i];
        const Point3 a = s.mesh.positions[c[0]], b = s.mesh.positions[c[2]];
        if (!s.mesh.is_quad(i) || s.mesh.patch_normals[i].y < -0.5f) continue;  // the lamp, and what it hides
        patches.push_back(i), normals.push_back(s.mesh.patch_normals[i]);
        points.push_back(0.5f * (a + b) + 1e-4f * normals.back());
      }
      for (const Irradiance h : illuminance(scene, points, normals, {.integrator = "path", .samples = 2048}))
        traced.push_back(h.v.g);
    }
    std::vector<float> off;
    for (size_t k = 0; k < patches.size(); ++k)
      if (traced[k] > 0.5f) off.push_back(std::abs(s.irradiances[patches[k]].v.g / traced[k] - 1));
    ASSERT_GT(off.size(), 50U);
    std::nth_element(off.begin(), off.begin() + std::ptrdiff_t(off.size() / 2), off.end());
    EXPECT_LT(off[off.size() / 2], 0.025f) << solver;
  }
}

}  // namespace
}  // namespace aktina
