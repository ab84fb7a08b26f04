#include <gtest/gtest.h>

#include "trace/integrator/light_scenes.h"

namespace aktina {
namespace {

using test::along;
using test::estimates;
using test::options;

/// A closed box that shines and reflects evenly all over: L = E / (pi (1 - rho)) with E = pi.
Scene furnace(float rho) {
  Scene scene;
  test::set_matt(test::add(scene, test::room(Point3(-1), Point3(1))), Rgb(rho), Rgb(1));
  return scene;
}

TEST(Path, FurnaceOfLambertianWalls) {
  for (const float rho : {0.0f, 0.3f, 0.8f}) {
    const auto l = estimates(furnace(rho), {0.2f, 0.1f, -0.3f}, {1, 0.3f, 0.2f}, "path:depth=1000", 200, 16);
    EXPECT_NEAR(l.mean(), 1 / (1 - double(rho)), 3 * l.standard_error() + 1e-4) << "reflectance " << rho;
  }
}

TEST(Path, WhiteFurnaceOfEveryMaterial) {
  // In even light from all around, what loses nothing cannot be seen.
  for (int kind = 0; kind < 6; ++kind) {
    Scene scene;
    scene.environment.colour = Radiance(Rgb(2));
    Material& m = test::add(scene, Sphere{1});
    if (kind == 0) test::set_matt(m, Rgb(1));
    if (kind == 1) test::set_metal(m, Rgb(1), 0);
    if (kind == 2) test::set_metal(m, Rgb(1), 0.5f);
    if (kind == 3) test::set_glass(m, 1.5f);
    if (kind == 4) m.base_colour = Rgb(1), m.metallic = 0, m.roughness = 0.4f;
    if (kind == 5) m.base_colour = Rgb(1), m.metallic = 0, m.roughness = 0;
    for (const float x : {0.0f, 0.7f, 0.95f}) {
      const auto l = estimates(scene, {x, 0, 5}, {0, 0, -1}, "path", 100, 16);
      EXPECT_NEAR(l.mean(), 2, 4 * l.standard_error() + 0.02) << "material " << kind << " at " << x;
    }
  }
}

TEST(Path, RouletteIsWithoutBias) {
  const Scene scene = furnace(0.7f);
  const auto early = estimates(scene, {0.2f, 0.1f, -0.3f}, {1, 0.3f, 0.2f}, "path:depth=1000,roulette=0", 400, 16);
  const auto never = estimates(scene, {0.2f, 0.1f, -0.3f}, {1, 0.3f, 0.2f}, "path:depth=100,roulette=1000", 100, 16);
  const double error = std::hypot(early.standard_error(), never.standard_error());
  EXPECT_LT(std::abs(early.mean() - never.mean()), 3.5 * error + 1e-4);
}

TEST(Path, DepthCountsBounces) {
  // L_d = sum of rho^k for k = 0 .. d in the furnace.
  const Scene scene = furnace(0.5f);
  double expected = 0;
  for (const int depth : {0, 1, 2, 3}) {
    expected += std::pow(0.5, depth);
    const std::string method = "path:roulette=100,depth=" + std::to_string(depth);
    const auto l = estimates(scene, {0, 0, 0}, {1, 0.3f, 0.2f}, method.c_str(), 100, 16);
    EXPECT_MEAN(l, expected);
  }
}

TEST(Path, ParallelMirrorsGiveAGeometricSeries) {
  // Between two mirrors that shine a little: L = e (1 + r + r^2 + ...), cut at the depth.
  Scene scene;
  for (const float z : {-1.0f, 1.0f}) {
    Mesh mesh = test::quad({-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z});
    if (z > 0)
      for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    Material& m = test::set_metal(test::add(scene, std::move(mesh)), Rgb(0.5f));
    m.emission = Radiance(Rgb(1));
  }
  for (const int depth : {0, 1, 4}) {
    const std::string method = "path:roulette=100,depth=" + std::to_string(depth);
    const double expected = (1 - std::pow(0.5, depth + 1)) / (1 - 0.5);
    EXPECT_NEAR(double(along(scene, {0.1f, 0.2f, 0}, {0, 0, 1}, options(method.c_str(), 4)).g), expected, 1e-4);
  }
}

TEST(Path, NoiseFallsWithTheRootOfTheSamples) {
  Scene scene = furnace(0.5f);
  test::set_matt(
      test::add(scene, test::quad({-0.2f, 0.9f, -0.2f}, {0.2f, 0.9f, -0.2f}, {0.2f, 0.9f, 0.2f}, {-0.2f, 0.9f, 0.2f})),
      Rgb(0), Rgb(50));
  const auto few = estimates(scene, {0, 0, 0}, {1, 0.3f, 0.2f}, "path", 600, 4);
  const auto many = estimates(scene, {0, 0, 0}, {1, 0.3f, 0.2f}, "path", 600, 64);
  // 16 times the samples: a quarter of the noise for random numbers, less for well-spread ones, which help the first
  // dimensions most.
  const double ratio = std::sqrt(few.variance() / many.variance());
  EXPECT_GT(ratio, 3.5);
  EXPECT_LT(ratio, 12);
}

TEST(Path, GlassSphereBlocksNoEnergy) {
  // A clear sphere before an even sky, seen from a matt floor: the floor is as bright as without it.
  Scene scene;
  scene.environment.colour = Radiance(Rgb(1));
  test::set_matt(test::add(scene, Disc{50}), Rgb(0.5f));
  const double open = double(along(scene, {0, 1, 0}, {0, -1, 0}, options("path", 256)).g);
  EXPECT_NEAR(open, 0.5, 2e-3);
  test::set_glass(test::add(scene, Sphere{0.5f}, test::translation({0, 0.6f, 0})), 1.5f);
  const auto under = estimates(scene, {2, 0.05f, 0}, {-1, -0.0249f, 0}, "path", 100, 64);
  EXPECT_NEAR(under.mean(), 0.5, 4 * under.standard_error() + 2e-3);
}

TEST(Path, HostileScenesGiveFinitePictures) {
  Scene scene;
  test::set_matt(test::add(scene, test::room(Point3(-1), Point3(1))), Rgb(1));
  Mesh flat;  // without area, and shining
  flat.positions = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  flat.triangles = {{0, 1, 2}, {0, 0, 0}};
  test::set_matt(test::add(scene, std::move(flat)), Rgb(0), Rgb(100));
  scene.lights.push_back({"on the wall", PointLight{{1, 0, 0}, Intensity(Rgb(1)), {}}, -1});
  scene.lights.push_back({"dark", PointLight{{0, 0.5f, 0}, Intensity(Rgb(0)), {}}, -1});
  test::set_matt(test::add(scene, Sphere{0}, test::translation({0.5f, 0, 0})), Rgb(0), Rgb(5));
  test::set_matt(test::add(scene, Sphere{0.2f}, Mat4(0)), Rgb(0), Rgb(5));
  const Camera camera = look_at({0, 0, 0.9f}, {0, 0, 0}, {0, 1, 0}, 2);
  for (const char* method : {"path", "direct", "whitted"})
    for (const int size : {1, 17}) {
      TraceStatistics statistics;
      const LayeredImage picture = trace(scene, camera, size, size, options(method, 8), nullptr, &statistics);
      EXPECT_EQ(statistics.not_finite, 0U) << method;
      for (const float x : picture.layers[0].image.pixels) EXPECT_TRUE(std::isfinite(x) && x >= 0) << method;
    }
}

TEST(Path, NothingShinesNothingIsSeen) {
  Scene scene;
  EXPECT_TRUE(is_black(along(scene, {0, 0, 0}, {0, 0, 1}, options("path", 1))));
  test::set_matt(test::add(scene, test::room(Point3(-1), Point3(1))), Rgb(0.5f));
  for (const char* method : {"path", "direct", "whitted"})
    EXPECT_TRUE(is_black(along(scene, {0, 0, 0}, {0, 0, 1}, options(method, 4)))) << method;
  scene.background = Radiance({0.1f, 0.2f, 0.3f});
  scene.instances.clear();
  for (const char* method : {"path", "direct", "whitted"})
    EXPECT_EQ(along(scene, {0, 0, 0}, {0, 0, 1}, options(method, 1)), Rgb(0.1f, 0.2f, 0.3f)) << method;
}

}  // namespace
}  // namespace aktina
