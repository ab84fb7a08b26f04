// From a scene to the light on it: what must hold whatever the method.
#include "aktina/radiosity/solve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/radiosity/solver/reconstruct.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

/// A closed room with a lamp in its ceiling and a box on the floor.
Scene lit_room() {
  Scene scene = room({2, 2, 2}, Rgb(0.6f, 0.5f, 0.4f));
  add_quad(scene, {0.7f, 1.999f, 0.7f}, {0.6f, 0, 0}, {0, 0, 0.6f}, Rgb(0), Rgb(100));
  add_box(scene, {0.5f, 0, 0.5f}, {0.5f, 0.8f, 0.5f}, Rgb(0.7f));
  return scene;
}

TEST(SolveRadiosity, UniformEmissionGivesTheFurnace) {
  for (const char* solver : {"progressive", "matrix", "stochastic_jacobi"}) {
    const Solution s = solve_radiosity(room({3, 2, 2.5f}, Rgb(0.5f), Rgb(10)),
                                       {.solver = solver, .patch_size = 0.4, .tolerance = 1e-4});
    EXPECT_TRUE(s.converged);
    const double off = solver == std::string("stochastic_jacobi") ? 0.1 : 0.02;  // noise
    for (const Radiosity b : s.radiosities) EXPECT_NEAR(b.v.g, 20, off) << "E / (1 - rho), everywhere";
    for (const Radiosity b : s.vertex_radiosities) EXPECT_NEAR(b.v.g, 20, off);
  }
}

/// Two rooms in one box, the lamp in the first; turned, so that nothing lies along an axis.
Scene two_rooms(bool thick) {
  Scene scene = room({6, 2.5f, 3}, Rgb(0.7f));
  add_quad(scene, {1, 2.49f, 1}, {0.6f, 0, 0}, {0, 0, 0.6f}, Rgb(0), Rgb(3000));
  if (thick)
    add_box(scene, {3, -0.1f, -0.1f}, {0.2f, 2.7f, 3.2f}, Rgb(0.7f));
  else
    for (const float z : {0.0f, 1.5f}) {
      add_quad(scene, {3, 0, z}, {0, 0, 1.5f}, {0, 2.5f, 0}, Rgb(0.7f));
      scene.materials.back().double_sided = true;
    }
  const Mat4 turn = glm::rotate(glm::rotate(Mat4(1), 0.4f, Vec3(0, 0, 1)), 0.7f, Vec3(1, 0, 0));
  for (Instance& instance : scene.instances) instance.to_world = turn * instance.to_world;
  return scene;
}

TEST(SolveRadiosity, AWallLetsNoLightThrough) {
  for (const char* mesher : {"uniform", "quadtree", "discontinuity"})
    for (const bool thick : {false, true}) {
      const Solution s = solve_radiosity(two_rooms(thick), {.mesher = mesher, .quality = "draft"});
      const Vec3 along(Mat3(glm::rotate(glm::rotate(Mat4(1), 0.4f, Vec3(0, 0, 1)), 0.7f, Vec3(1, 0, 0)))[0]);
      double bright = 0, dark = 0, bright_area = 0, dark_area = 0;
      for (size_t i = 0; i < s.mesh.size(); ++i) {
        ASSERT_GT(s.mesh.areas[i], 0);
        ASSERT_TRUE(std::isfinite(s.irradiances[i].v.g));
        Point3 p(0);
        for (const uint32_t v : s.mesh.patches[i]) p += 0.25f * s.mesh.positions[v];
        const double area = double(s.mesh.areas[i]), flux = area * double(s.irradiances[i].v.g);
        (dot(along, p) > 3.001f ? dark : bright) += flux, (dot(along, p) > 3.001f ? dark_area : bright_area) += area;
      }
      const double most = thick ? 0.1 : 2e-4;  // of the thick wall, one side is lit
      EXPECT_LT(dark / dark_area, most * bright / bright_area) << mesher;
    }
}

TEST(SolveRadiosity, ProgressiveRefinementConvergesToTheMatrixSolution) {
  RadiosityOptions options{.solver = "progressive", .patch_size = 0.4, .tolerance = 1e-5};
  const Solution progressive = solve_radiosity(lit_room(), options);
  options.solver = "matrix", options.tolerance = 1e-9;
  const Solution matrix = solve_radiosity(lit_room(), options);
  for (size_t i = 0; i < matrix.mesh.size(); ++i)
    EXPECT_NEAR(progressive.irradiances[i].v.r, matrix.irradiances[i].v.r, 2e-4f * matrix.irradiances[i].v.r + 1e-3f);
}

TEST(SolveRadiosity, AnyFormFactorMethodGivesTheSameLight) {
  Scene scene = room({2, 2, 2}, Rgb(0.6f));
  scene.materials[1].emission = lambertian_radiance(Radiosity(Rgb(100)));
  RadiosityOptions options{.solver = "progressive", .mesher = "uniform:shooter=1"};
  options.patch_size = 0.41, options.indirect_size = 0;
  const Solution rays = solve_radiosity(scene, options);
  options.formfactor = "analytic";
  const Solution rows = solve_radiosity(scene, options);
  for (size_t i = 0; i < rays.mesh.size(); ++i)
    EXPECT_NEAR(rows.irradiances[i].v.g, rays.irradiances[i].v.g, 0.12f * rays.irradiances[i].v.g);
  options.formfactor = "ray_cast:samples=0";
  EXPECT_THROW(solve_radiosity(scene, options), Error);
  options.formfactor = "rays";
  EXPECT_THROW(solve_radiosity(scene, options), Error);
}

/// A lamp hangs close below the ceiling, which shines: whatever stands before the middle of a large shooter must not
/// stand before all of it.
TEST(SolveRadiosity, AnyFormFactorMethodSeesPastWhatHidesTheMiddle) {
  Scene scene = room({4, 2.5f, 3}, Rgb(0.5f));
  scene.materials[1].emission = lambertian_radiance(Radiosity(Rgb(100)));
  add_quad(scene, {1.7f, 2.45f, 1.2f}, {0.6f, 0, 0}, {0, 0, 0.6f}, Rgb(0));
  RadiosityOptions options{.solver = "matrix", .patch_size = 1, .indirect_size = 0};
  const auto absorbed = [&](const char* formfactor) {
    options.formfactor = formfactor;
    const Solution s = solve_radiosity(scene, options);
    return s.absorbed / s.emitted;
  };
  const double exact = absorbed("contour");
  EXPECT_GT(exact, 0.93) << "less what ends at the back of the lamp, which is black";
  EXPECT_LE(exact, 1.0 + 1e-6);
  for (const char* method : {"analytic", "cubature", "hybrid", "hemicube:hemicubes=16", "monte_carlo"})
    EXPECT_NEAR(absorbed(method), exact, 0.02) << method;
}

double median_difference(const Solution& a, const Solution& b) {
  std::vector<double> differences;
  for (size_t i = 0; i < a.irradiances.size(); ++i)
    if (b.irradiances[i].v.g > 0.1f)
      differences.push_back(double(std::abs(a.irradiances[i].v.g / b.irradiances[i].v.g - 1)));
  std::sort(differences.begin(), differences.end());
  return differences[differences.size() / 2];
}

TEST(SolveRadiosity, DirectLightApartAgreesWithAllLightOnAllPatches) {
  RadiosityOptions options{.solver = "progressive", .patch_size = 0.1, .tolerance = 1e-4, .indirect_size = 0};
  const Solution all = solve_radiosity(lit_room(), options);
  for (const char* solver : {"progressive", "stochastic_jacobi"}) {
    options.solver = solver, options.indirect_size = 2;
    const Solution apart = solve_radiosity(lit_room(), options);
    ASSERT_EQ(apart.mesh.size(), all.mesh.size());
    EXPECT_LT(median_difference(apart, all), 0.015) << solver;
  }
}

TEST(SolveRadiosity, QualitiesDiffer) {
  const Solution draft = solve_radiosity(lit_room(), {.quality = "draft"});
  const Solution normal = solve_radiosity(lit_room());
  EXPECT_GT(normal.mesh.size(), 2 * draft.mesh.size());
  EXPECT_LT(normal.unshot, draft.unshot);
  EXPECT_THAT([] { solve_radiosity(lit_room(), {.quality = "best"}); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("draft, normal, fine")));
}

TEST(SolveRadiosity, ManyEmittersAreMoreThanAreComputedApart) {
  // Walls that emit as a whole are cut into more emitters than that; the furnace tells whether the others count.
  RadiosityOptions options{.patch_size = 0.1, .indirect_size = 1};
  const Solution s = solve_radiosity(room({1, 1, 1}, Rgb(0.5f), Rgb(10)), options);
  for (const Radiosity b : s.radiosities) EXPECT_NEAR(b.v.g, 20, 1);
  for (const Irradiance h : s.direct_irradiances) EXPECT_NEAR(h.v.g, 10, 1.5);
}

TEST(SolveRadiosity, NoIndirectLightGoesThroughAWallOnTheFloor) {
  // Two rooms whose floors continue each other; the lamp is in the left one.
  Scene scene = room({1, 1, 1}, Rgb(0.7f)), other = room({1, 1, 1}, Rgb(0.7f));
  for (Mesh& mesh : other.meshes) {
    for (Point3& p : mesh.positions) p.x += 1;
    mesh.material += int(scene.materials.size());
    Instance instance;
    instance.mesh = int(scene.meshes.size());
    scene.meshes.push_back(mesh), scene.instances.push_back(instance);
  }
  scene.materials.insert(scene.materials.end(), other.materials.begin(), other.materials.end());
  scene.lights.push_back({"lamp", PointLight{{0.5f, 0.5f, 0.5f}, Intensity(Rgb(100))}, -1});
  const Solution s = solve_radiosity(scene, {.quality = "draft", .patch_size = 0.1});
  double left = 0, right = 0;
  for (size_t i = 0; i < s.mesh.size(); ++i) {
    const float x = s.mesh.positions[s.mesh.patches[i][0]].x, x2 = s.mesh.positions[s.mesh.patches[i][2]].x;
    if (std::max(x, x2) < 0.99f) left = std::max(left, double(s.irradiances[i].v.g));
    if (std::min(x, x2) > 1.01f) right = std::max(right, double(s.irradiances[i].v.g));
  }
  EXPECT_GT(left, 100);
  EXPECT_LT(right, 1e-3 * left);
}

TEST(SolveRadiosity, AccountsForTheEnergyOfAClosedRoom) {
  const Solution s = solve_radiosity(lit_room(), {.patch_size = 0.2});
  EXPECT_NEAR(s.emitted, 36, 1e-3);
  EXPECT_NEAR(s.absorbed + s.escaped + s.unshot * s.emitted, s.emitted, 1e-4 * s.emitted);
  EXPECT_NEAR(s.escaped, 0, 0.02 * s.emitted) << "what midpoints of patches misjudge";
}

TEST(SolveRadiosity, AmbientLightBringsEarlyStepsNearer) {
  RadiosityOptions options{.solver = "progressive", .patch_size = 0.4, .tolerance = 1e-5, .indirect_size = 0};
  const Solution final = solve_radiosity(lit_room(), options);
  options.most_steps = 8;
  double plain = 0, with_ambient = 0;
  uint64_t calls = 0;
  options.each_step = [&](const RadiosityOptions::Step& step) {
    EXPECT_EQ(step.step, ++calls);
    plain = with_ambient = 0;
    for (size_t i = 0; i < final.mesh.size(); ++i) {
      const float target = final.radiosities[i].v.g, now = step.solution->radiosities[i].v.g;
      plain += double(std::abs(target - now));
      with_ambient += double(std::abs(target - now - final.mesh.reflectances[i].g * step.ambient.v.g));
    }
  };
  const Solution s = solve_radiosity(lit_room(), options);
  EXPECT_EQ(calls, 8U);
  EXPECT_FALSE(s.converged);
  EXPECT_LT(with_ambient, 0.5 * plain);
}

TEST(SolveRadiosity, PointLightInAnEmptyRoomIsTheInverseSquareLaw) {
  Scene scene = room({4, 4, 4}, Rgb(0));
  scene.lights.push_back({"lamp", PointLight{{2, 2, 2}, Intensity(Rgb(100))}, -1});
  const Solution s = solve_radiosity(scene, {.patch_size = 0.25});
  for (size_t i = 0; i < s.mesh.size(); ++i) {
    const auto& c = s.mesh.patches[i];
    const Vec3 centre =
        (s.mesh.positions[c[0]] + s.mesh.positions[c[1]] + s.mesh.positions[c[2]] + s.mesh.positions[c[3]]) * 0.25f;
    const float d = length(centre - Vec3(2)), expected = 100 * 2 / (d * d * d);
    EXPECT_NEAR(s.irradiances[i].v.r, expected, 0.03f * expected);
    EXPECT_EQ(s.direct_irradiances[i], s.irradiances[i]);
  }
  EXPECT_NEAR(s.emitted, 4 * kPi * 100, 3) << "all of the lamp's flux arrives";
}

TEST(SolveRadiosity, GlassLetsItsShareThrough) {
  Scene scene = room({2, 2, 2}, Rgb(0));
  scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, Irradiance(Rgb(100))}, -1});
  scene.instances.erase(scene.instances.begin() + 1);  // no ceiling
  const size_t pane = add_quad(scene, {0, 1, 0}, {2, 0, 0}, {0, 0, 2}, Rgb(0));
  Material& glass = scene.materials[size_t(scene.meshes[size_t(scene.instances[pane].mesh)].material)];
  glass.alpha_mode = AlphaMode::blend, glass.alpha = 0.4f;
  const Solution s = solve_radiosity(scene, {.patch_size = 0.5});
  for (size_t i = 0; i < s.mesh.size(); ++i)
    if (s.mesh.centres[i].instance == 0) {
      EXPECT_NEAR(s.irradiances[i].v.r, 60, 0.01);
    }
}

TEST(SolveRadiosity, BothSidesOfATwoSidedSurfaceAreLit) {
  Scene scene = room({2, 2, 2}, Rgb(0.5f));
  const size_t sheet = add_quad(scene, {0.5f, 1, 0.5f}, {0, 0, 1}, {1, 0, 0}, Rgb(0.5f));  // front up
  scene.materials.back().double_sided = true;
  scene.lights.push_back({"lamp", PointLight{{1, 1.8f, 1}, Intensity(Rgb(100))}, -1});
  const Solution s = solve_radiosity(scene, {.patch_size = 0.25});
  for (size_t i = 0; i < s.mesh.size(); ++i) {
    const bool two_sided = s.mesh.centres[i].instance == sheet;
    EXPECT_EQ(bool(s.mesh.two_sided[i]), two_sided);
    if (!two_sided) {
      EXPECT_EQ(s.back_irradiances[i], Irradiance());
      continue;
    }
    EXPECT_GT(s.direct_irradiances[i].v.g, 10);
    EXPECT_EQ(s.back_direct_irradiances[i], Irradiance());
    EXPECT_GT(s.back_irradiances[i].v.g, 1);
  }
}

TEST(SolveRadiosity, SameBytesForAnyNumberOfThreads) {
  set_thread_count(1);
  const Solution one = solve_radiosity(lit_room(), {.patch_size = 0.2, .most_steps = 40});
  set_thread_count(2);
  const Solution two = solve_radiosity(lit_room(), {.patch_size = 0.2, .most_steps = 40});
  set_thread_count(0);
  EXPECT_EQ(one.irradiances, two.irradiances);
  EXPECT_EQ(one.vertex_irradiances, two.vertex_irradiances);
  EXPECT_EQ(one.escaped, two.escaped);
}

TEST(SolveRadiosity, CancelledWorkIsKept) {
  Progress progress;
  RadiosityOptions options{.solver = "progressive", .patch_size = 0.4};
  options.each_step = [&](const RadiosityOptions::Step& step) {
    if (step.step == 3) progress.cancel();
  };
  const Solution s = solve_radiosity(lit_room(), options, &progress);
  EXPECT_EQ(s.steps, 3U);
  EXPECT_FALSE(s.converged);
  EXPECT_EQ(s.vertex_irradiances.size(), s.mesh.positions.size());
}

TEST(SolveRadiosity, RefusesASceneWithoutLight) {
  EXPECT_THAT(
      [] {
        solve_radiosity(room({1, 1, 1}, Rgb(0.5f)));
      },
      testing::ThrowsMessage<Error>(testing::HasSubstr("nothing shines")));
}

TEST(Reconstruct, ConstantsAndLinearFieldsAreExactUpToTheBorder) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {2, 0, 0}, {0, 0, -1}, Rgb(0.5f));
  add_quad(scene, {2, 0, 0}, {1, 0, 0}, {0, 0, -1}, Rgb(0.5f));  // continues it
  Solution s = solve_radiosity(
      [&] {
        Scene lit = scene;
        lit.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, Irradiance(Rgb(7))}, -1});
        return lit;
      }(),
      {.patch_size = 0.21});
  for (const Irradiance h : s.vertex_irradiances) EXPECT_NEAR(h.v.r, 7, 1e-5);
  const auto field = [](Point3 p) { return 5 + 2 * p.x - 3 * p.z; };
  for (size_t i = 0; i < s.mesh.size(); ++i) {
    const auto& c = s.mesh.patches[i];
    s.irradiances[i].v = Rgb(field(
        (s.mesh.positions[c[0]] + s.mesh.positions[c[1]] + s.mesh.positions[c[2]] + s.mesh.positions[c[3]]) * 0.25f));
  }
  reconstruct_vertices(s);
  for (size_t v = 0; v < s.mesh.positions.size(); ++v)
    EXPECT_NEAR(s.vertex_irradiances[v].v.r, field(s.mesh.positions[v]), 1e-4);
}

TEST(Reconstruct, DoesNotSmoothOverCreases) {
  Scene scene = room({1, 1, 1}, Rgb(0));
  scene.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, Irradiance(Rgb(7))}, -1});
  scene.instances.erase(scene.instances.begin() + 1);
  const Solution s = solve_radiosity(scene, {.patch_size = 0.25});
  for (size_t v = 0; v < s.mesh.positions.size(); ++v)
    EXPECT_NEAR(s.vertex_irradiances[v].v.r, s.mesh.normals[v].y > 0.5f ? 7 : 0, 1e-5);
}

TEST(LitScene, ShowsRadianceWithoutComputingLight) {
  const Scene scene = room({3, 2, 2.5f}, Rgb(0.5f, 0.25f, 0.75f), Rgb(0));
  Scene lit_by_sun = scene;
  lit_by_sun.instances.erase(lit_by_sun.instances.begin() + 1);
  lit_by_sun.lights.push_back({"sun", DirectionalLight{{0, -1, 0}, Irradiance(Rgb(10))}, -1});
  Camera camera = look_at({1.5f, 1.9f, 1.25f}, {1.5f, 0, 1.25f}, {1, 0, 0}, 0.5f);
  const Solution s = solve_radiosity(lit_by_sun, {.patch_size = 0.25});
  const LayeredImage picture = render_solution(lit_by_sun, s, camera, 16, 16, 1);
  const Rgb seen = picture.layers[0].image.rgb(8, 8);
  size_t middle = 0;
  for (size_t v = 0; v < s.mesh.positions.size(); ++v)
    if (length(s.mesh.positions[v] - Vec3(1.5f, 0, 1.25f)) < length(s.mesh.positions[middle] - Vec3(1.5f, 0, 1.25f)))
      middle = v;
  const Rgb radiosity = s.vertex_radiosities[middle].v;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], radiosity[c] * float(kInvPi), 0.02f * seen[c]);
}

TEST(LitScene, RefusesASolutionOfAnotherScene) {
  const Solution s = solve_radiosity(lit_room(), {.patch_size = 1});
  EXPECT_THAT(
      [&] {
        lit_scene(room({1, 1, 1}, Rgb(0.5f)), s);
      },
      testing::ThrowsMessage<Error>(testing::HasSubstr("another scene")));
}

/// One texel of a dark picture, 60 degrees high: E = L omega sin 60.
TEST(SolveRadiosity, TheSunInAPictureOfTheSkyIsFound) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, Rgb(0.5f));
  Image sky(360, 180, 3, 0);
  sky.set_rgb(100, 30, Rgb(1e6f));
  scene.environment = {std::move(sky), Radiance(Rgb(1)), 0};
  const Solution s = solve_radiosity(scene, {.patch_size = 0.03});
  // A texel is interpolated over twice its width and height: as a tent of the same integral.
  const double high = kPi / 2 - kPi * 30.5 / 180, texel = kPi / 180;
  const double expected = 1e6 * texel * texel * std::cos(high) * std::sin(high);
  double mean = 0, squares = 0;
  for (const Irradiance h : s.irradiances) mean += double(h.v.g) / double(s.irradiances.size());
  for (const Irradiance h : s.irradiances) squares += std::pow(double(h.v.g) / mean - 1, 2);
  EXPECT_NEAR(mean / expected, 1, 0.02);
  EXPECT_LT(std::sqrt(squares / double(s.irradiances.size())), 0.15) << "noise of a patch, of 32 rays towards it";
}

TEST(SolveRadiosity, WhateverIsStoppedHasNotConverged) {
  for (const char* solver : {"stochastic_jacobi", "matrix", "gmres", "progressive", "hierarchical"}) {
    Progress progress;
    progress.cancel();
    EXPECT_FALSE(solve_radiosity(lit_room(), {.solver = solver, .patch_size = 0.5}, &progress).converged) << solver;
  }
}

TEST(LitScene, UnlitMaterialsStayAsTheyAre) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, Rgb(0.5f));
  scene.materials[0].unlit = true, scene.materials[0].base_colour = {0.2f, 0.4f, 0.6f};
  scene.cameras.push_back(look_at({0.5f, 0.5f, 1}, {0.5f, 0.5f, 0}, {0, 1, 0}, 0.5f));
  const Solution s = solve_radiosity(scene, {.patch_size = 0.5});
  const Scene lit = lit_scene(scene, s);
  EXPECT_EQ(lit.materials[size_t(lit.meshes[0].material)].base_colour, Rgb(0.2f, 0.4f, 0.6f));
  const LayeredImage picture = render_solution(scene, s, scene.cameras[0], 8, 8);
  const float* middle = &picture.layers[0].image.pixels[3 * (4 * 8 + 4)];
  EXPECT_NEAR(middle[0], 0.2f, 1e-4f);
  EXPECT_NEAR(middle[2], 0.6f, 1e-4f);
}

}  // namespace
}  // namespace aktina
