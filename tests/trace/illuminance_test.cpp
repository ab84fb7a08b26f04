#include "aktina/trace/illuminance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "raster/scenes.h"

namespace aktina {
namespace {

constexpr Vec3 kUp{0, 1, 0};

/// A closed box of the given reflectance whose walls shine inwards.
Scene shining_box(float reflectance, float radiance) {
  Scene scene;
  const int wall = test::add_matt(scene, Rgb(reflectance));
  scene.materials[size_t(wall)].emission = Radiance(Rgb(radiance));
  const auto corner = [](int i) { return Point3(i & 4 ? 1 : -1, i & 2 ? 1 : -1, i & 1 ? 1 : -1); };
  for (const auto& f : {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    test::add_mesh(scene, test::quad(corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3])), wall);
  return scene;
}

TEST(MeasureIlluminance, InverseSquareAndCosineOfAPointLight) {
  Scene scene;
  scene.lights.push_back({"lamp", PointLight{{0, 2, 0}, Intensity(Rgb(100)), {}}, -1});
  const Point3 points[] = {{0, 0, 0}, {2, 0, 0}};
  const Vec3 normals[] = {kUp, kUp};
  const Measurement m = measure_illuminance(scene, points, normals, {});
  EXPECT_NEAR(m.lux[0], 25, 0.01);
  EXPECT_NEAR(m.lux[1], 100 / 8.0 * std::sqrt(0.5), 0.01);
  EXPECT_TRUE(m.reached);
}

TEST(MeasureIlluminance, ClosedBoxHasTheSumOfItsSeries) {
  // B = pi L / (1 - rho) everywhere, and E = B inside.
  const Scene scene = shining_box(0.5f, 10);
  const Point3 points[] = {{0.3f, -0.2f, 0.1f}, {0, 0.9f, 0}};
  const Vec3 normals[] = {kUp, {1, 0, 0}};
  MeasureOptions options;
  options.integrator = "path:depth=64";
  options.target_error = 0.01;
  const Measurement m = measure_illuminance(scene, points, normals, options);
  for (size_t i = 0; i < 2; ++i) EXPECT_NEAR(m.lux[i], kPi * 10 / 0.5, 5 * m.standard_errors[i] + 0.01);
  EXPECT_LE(m.error, 0.01);
}

TEST(MeasureIlluminance, PointsInsideOfBodiesAreLeftOut) {
  Scene scene;
  const int wood = test::add_matt(scene, Rgb(0.5f));
  const auto corner = [](int i) { return Point3(i & 4 ? 1 : -1, i & 2 ? 1 : -1, i & 1 ? 1 : -1); };
  for (const auto& f : {std::array{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}})
    test::add_mesh(scene, test::quad(corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3])), wood);
  scene.environment.colour = Radiance(Rgb(1));
  const Point3 points[] = {{0.1f, 0, 0.2f}, {0.1f, 2, 0.2f}};
  const Vec3 normals[] = {kUp, kUp};
  const Measurement m = measure_illuminance(scene, points, normals, {});
  EXPECT_TRUE(std::isnan(m.lux[0]));
  EXPECT_NEAR(m.lux[1], kPi, 0.01) << "an open sky of 1 cd/m^2";
  EXPECT_EQ(m.inside, 1u);
}

TEST(MeasureIlluminance, StopsAtTheMostSamplesAndSaysSo) {
  const Scene scene = shining_box(0.5f, 10);
  const Point3 point{0, 0, 0};
  MeasureOptions options;
  options.target_error = 1e-6, options.most_samples = 512;
  const Measurement m = measure_illuminance(scene, {&point, 1}, {&kUp, 1}, options);
  EXPECT_EQ(m.samples, 512);
  EXPECT_FALSE(m.reached);
}

}  // namespace
}  // namespace aktina
