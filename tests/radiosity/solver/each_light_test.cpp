#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/radiosity/solve.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

using testing::ElementsAre;

/// A room with a lamp in the ceiling, a faint point light and a sky through a window.
Scene three_lights() {
  Scene scene = room({2, 2, 2}, Rgb(0.6f, 0.5f, 0.4f));
  scene.instances.erase(scene.instances.begin() + 2);  // open at x = 0
  add_quad(scene, {0.7f, 1.999f, 0.7f}, {0.6f, 0, 0}, {0, 0, 0.6f}, Rgb(0.2f), Rgb(100));
  scene.nodes.push_back({"ceiling", -1, Mat4(1), Mat4(1)});
  scene.instances.back().node = int(scene.nodes.size()) - 1;
  scene.lights.push_back({"candle", PointLight{{1.5f, 0.5f, 1.5f}, Intensity(Rgb(0.05f))}, -1});
  scene.environment.colour = Radiance(Rgb(1, 2, 4));
  return scene;
}

std::vector<const Solution*> pointers(const std::vector<LightSolution>& lights) {
  std::vector<const Solution*> all;
  for (const LightSolution& each : lights) all.push_back(&each.solution);
  return all;
}

/// Root of the mean square difference over the mean, by area, green.
double difference(const Solution& a, const Solution& b) {
  double squares = 0, sum = 0, area = 0;
  for (size_t i = 0; i < a.mesh.size(); ++i) {
    const auto w = double(a.mesh.areas[i]);
    const auto d = double(a.irradiances[i].v.g - b.irradiances[i].v.g);
    squares += w * d * d, sum += w * double(b.irradiances[i].v.g), area += w;
  }
  return std::sqrt(squares / area) / (sum / area);
}

TEST(EachLight, AddsUpToTheLightOfAll) {
  const Scene scene = three_lights();
  for (const char* solver : {"matrix", "progressive", "stochastic_jacobi", "hierarchical", "clustering"}) {
    const RadiosityOptions options{.solver = solver, .patch_size = 0.25, .tolerance = 1e-4, .target_error = 0.01};
    const Solution all = solve_radiosity(scene, options);
    const std::vector<LightSolution> lights = solve_each_light(scene, options);
    ASSERT_EQ(lights.size(), 3U);
    EXPECT_THAT((std::vector<std::string>{lights[0].name, lights[1].name, lights[2].name}),
                ElementsAre("candle", "ceiling", "environment"));
    const Solution sum = mixed(pointers(lights), std::vector<double>(3, 1));
    EXPECT_LT(difference(sum, all), 0.01) << solver;
    EXPECT_NEAR(sum.emitted, all.emitted, 1e-4 * all.emitted) << solver;
    EXPECT_NEAR(sum.absorbed + sum.escaped + sum.unshot * sum.emitted, sum.emitted, 1e-6 * sum.emitted);
  }
}

TEST(EachLight, AFaintLightIsFoundAsExactlyAsABrightOne) {
  Scene scene = three_lights();
  const RadiosityOptions options{.patch_size = 0.25, .target_error = 0.01};
  const std::vector<LightSolution> lights = solve_each_light(scene, options);
  scene.environment.colour = Radiance(Rgb(0));
  for (Material& m : scene.materials) m.emission = Radiance(Rgb(0));
  const Solution alone = solve_radiosity(scene, options),
                 exact = solve_radiosity(scene, {.solver = "matrix", .patch_size = 0.25, .tolerance = 1e-5});
  EXPECT_LT(difference(lights[0].solution, exact), 1.5 * difference(alone, exact) + 0.002);
}

TEST(EachLight, IsDimmedInProportion) {
  const Scene scene = three_lights();
  const std::vector<LightSolution> lights = solve_each_light(scene, {.solver = "matrix", .patch_size = 0.5});
  const Solution mix = mixed(pointers(lights), std::vector<double>{0, 2, 0.5});
  for (size_t i = 0; i < mix.mesh.size(); ++i) {
    const Rgb expected = lights[1].solution.irradiances[i].v * 2.0f + lights[2].solution.irradiances[i].v * 0.5f;
    EXPECT_NEAR(double(mix.irradiances[i].v.r), double(expected.r), 1e-5 * double(expected.r) + 1e-6);
    const Rgb b = mix.mesh.emissions[i].v + mix.mesh.reflectances[i] * mix.irradiances[i].v;
    EXPECT_NEAR(double(mix.radiosities[i].v.g), double(b.g), 1e-4 * double(b.g) + 1e-6);
  }
  EXPECT_NEAR(mix.emitted, 2 * lights[1].solution.emitted + 0.5 * lights[2].solution.emitted, 1e-9 * mix.emitted);
}

TEST(EachLight, MixRefusesWhatDoesNotBelongTogether) {
  const Scene scene = three_lights();
  const std::vector<LightSolution> lights = solve_each_light(scene, {.solver = "matrix", .patch_size = 0.5});
  const Solution other = solve_radiosity(scene, {.solver = "matrix", .patch_size = 0.3});
  const Solution* two[] = {&lights[0].solution, &other};
  EXPECT_THROW(mixed(two, std::vector<double>{1, 1}), Error);
  EXPECT_THROW(mixed(pointers(lights), std::vector<double>{1, 1}), Error);
  EXPECT_THROW(mixed(pointers(lights), std::vector<double>{1, 1, -1}), Error);
  EXPECT_THROW(mixed(pointers(lights), std::vector<double>{1, 1, std::nan("")}), Error);
  EXPECT_THROW(mixed({}, {}), Error);
}

TEST(EachLight, NeedsDirectLightApart) {
  try {
    solve_each_light(three_lights(), {.patch_size = 0.5, .indirect_size = 0});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), Code::unsupported);
  }
}

TEST(EachLight, LampsOfOneNameCountAsOne) {
  Scene scene = three_lights();
  scene.lights.push_back({"candle", PointLight{{1.5f, 0.5f, 0.5f}, Intensity(Rgb(0.05f))}, -1});
  scene.lights.push_back({"", PointLight{{1.5f, 0.5f, 0.5f}, Intensity(Rgb(0.05f))}, -1});
  const std::vector<LightSolution> lights = solve_each_light(scene, {.solver = "matrix", .patch_size = 0.5});
  ASSERT_EQ(lights.size(), 4U);
  EXPECT_EQ(lights[1].name, "lamp 2");
  EXPECT_GT(lights[0].solution.emitted, 1.5 * lights[1].solution.emitted);
}

}  // namespace
}  // namespace aktina
