// Meshes refined by direct light.
#include "aktina/radiosity/solver/adaptive_direct.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/parallel.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

/// A floor half in the shade of a plate, under the sun: the line x = 0.7 parts light from shade. The plate is
/// one-sided, its back towards the floor.
Scene half_in_the_shade() {
  Scene scene;
  add_quad(scene, {0, 0, 2}, {2, 0, 0}, {0, 0, -2}, Rgb(0.5f));
  add_quad(scene, {-1, 1, 3}, {1.7f, 0, 0}, {0, 0, -4}, Rgb(0.5f));
  scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, Irradiance(Rgb(100))}, -1});
  return scene;
}

/// RMS over the floor of what is shown, vertices interpolated, against the closed form.
double floor_error(const Solution& s) {
  double sum = 0, area = 0;
  for (size_t i = 0; i < s.mesh.size(); ++i) {
    if (s.mesh.centres[i].instance != 0) continue;
    const auto& c = s.mesh.patches[i];
    const std::array<std::array<size_t, 3>, 2> triangles = {{{0, 1, 2}, {0, 2, 3}}};
    for (size_t t = 0; t < (s.mesh.is_quad(i) ? 2U : 1U); ++t)
      for (int k = 0; k < 36; ++k) {
        const auto row = k / 6;
        const float u = std::sqrt((float(k % 6) + 0.5f) / 6), v = (float(row) + 0.5f) / 6;
        const float w[3] = {1 - u, u * (1 - v), u * v};
        Point3 p(0);
        float h = 0;
        for (size_t n = 0; n < 3; ++n)
          p += w[n] * s.mesh.positions[c[triangles[t][n]]], h += w[n] * s.vertex_irradiances[c[triangles[t][n]]].v.g;
        const double off = double(h) - (p.x > 0.7f ? 100 : 0), weight = double(s.mesh.areas[i]);
        sum += weight * off * off, area += weight;
      }
  }
  return std::sqrt(sum / area);
}

TEST(AdaptiveDirect, FollowsTheEdgeOfAShadow) {
  const Scene scene = half_in_the_shade();
  const double coarse = floor_error(solve_radiosity(scene, {.patch_size = 0.2}));
  double last = coarse;
  for (const int depth : {1, 2, 3}) {
    const Solution s = solve_radiosity(scene, {.mesher = "quadtree:depth=" + std::to_string(depth), .patch_size = 0.2});
    const double error = floor_error(s);
    EXPECT_LT(error, 0.85 * last) << "the width of the smeared edge is halved: the error falls by 0.7";
    last = error;
    for (size_t i = 0; i < s.mesh.size(); ++i) {
      const float x = s.mesh.positions[s.mesh.patches[i][0]].x;
      if (s.mesh.centres[i].instance != 0 || std::abs(x - 0.7f) < 0.61f) continue;
      EXPECT_NEAR(s.mesh.areas[i], 0.04f, 1e-4f) << "nothing happens there";
    }
  }
  const Solution uniform = solve_radiosity(scene, {.patch_size = 0.025});
  EXPECT_LT(last, 1.15 * floor_error(uniform)) << "as patches of that size everywhere, but for coarser neighbours";
}

TEST(AdaptiveDirect, DepthZeroIsTheUniformMesh) {
  Scene scene = half_in_the_shade();
  const Solution uniform = solve_radiosity(scene, {.patch_size = 0.2});
  const Solution quadtree = solve_radiosity(scene, {.mesher = "quadtree:depth=0", .patch_size = 0.2});
  EXPECT_EQ(uniform.mesh.patches, quadtree.mesh.patches);
  EXPECT_EQ(uniform.irradiances, quadtree.irradiances);
}

TEST(AdaptiveDirect, WhatStaysIsNotComputedAnewAndIsRight) {
  // A lamp near a wall, nothing in the way: factors are exact, so the same whenever they are computed.
  Scene scene = room({2, 2, 2}, Rgb(0.5f));
  add_quad(scene, {0.2f, 1.99f, 0.8f}, {0.4f, 0, 0}, {0, 0, 0.4f}, Rgb(0), Rgb(100));
  const RadiosityOptions options{.formfactor = "ray_cast", .patch_size = 0.25, .target_error = 0.01};
  const MeshOptions mesh_options{.patch_size = 0.25, .coarse = 2};
  Warnings warnings;
  PatchMesh mesh = make_method(meshers(), "mesher", "uniform")->mesh(scene, mesh_options, warnings);
  const size_t first = mesh.size();
  const Visibility visibility(scene);
  KeptDirectLight kept(nullptr);
  const DirectLight light =
      refine_by_direct_light(scene, visibility, {3, 20}, options, mesh_options, mesh, kept, nullptr);
  EXPECT_GT(mesh.size(), 2 * first);
  const Sides sides(mesh);
  DirectLight anew;
  const std::vector<float> open(sides.size(), 1);
  const LightGroup lights = all_lights(scene);
  DirectSources(lights, sides, open, visibility, options, mesh_options).shine_on(sides.all(), anew, kept, nullptr);
  for (size_t s = 0; s < sides.size(); ++s) EXPECT_NEAR(light.all[s].g, anew.all[s].g, 1e-5f * anew.all[s].g + 1e-6f);
}

TEST(AdaptiveDirect, BacksAreLookedAtToo) {
  Scene scene = half_in_the_shade();
  scene.lights[0].light = DirectionalLight{{0, 1, 0}, Irradiance(Rgb(100))};  // from below
  std::swap(scene.instances[0].to_world, scene.instances[1].to_world);
  scene.instances[1].to_world[3] = Vec4(0, -2, 0, 1);  // the plate below the floor
  scene.materials[0].double_sided = true;
  const Solution s = solve_radiosity(scene, {.mesher = "quadtree:depth=2", .patch_size = 0.2});
  float smallest = 1;
  for (size_t i = 0; i < s.mesh.size(); ++i)
    if (s.mesh.centres[i].instance == 0) smallest = std::min(smallest, s.mesh.areas[i]);
  EXPECT_LT(smallest, 0.04f / 15);
}

TEST(AdaptiveDirect, SameBytesForAnyNumberOfThreads) {
  const auto solve = [](int threads) {
    set_thread_count(threads);
    Scene scene = half_in_the_shade();
    add_quad(scene, {0.2f, 0.9f, 0.8f}, {0.4f, 0, 0}, {0, 0, 0.4f}, Rgb(0), Rgb(100));
    return solve_radiosity(scene, {.mesher = "quadtree", .patch_size = 0.2});
  };
  const Solution one = solve(1), two = solve(2);
  set_thread_count(0);
  EXPECT_EQ(one.mesh.patches, two.mesh.patches);
  EXPECT_EQ(one.irradiances, two.irradiances);
}

}  // namespace
}  // namespace aktina
