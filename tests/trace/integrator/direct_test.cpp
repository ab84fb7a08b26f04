#include <gtest/gtest.h>

#include "aktina/trace/illuminance.h"
#include "trace/integrator/light_scenes.h"

namespace aktina {
namespace {

using test::along;
using test::estimates;
using test::options;

/// A white floor: its radiance is E / pi.
Scene floor_scene() {
  Scene scene;
  test::set_matt(test::add(scene, test::quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9})), Rgb(1));
  return scene;
}
double illuminance_at_origin(const Scene& scene, const char* method, int samples = 64) {
  return kPi * double(along(scene, {0.3f, 1, 0.2f}, {-0.3f, -1, -0.2f}, options(method, samples)).g);
}

TEST(Direct, PointSpotAndDistantLampsHaveClosedForms) {
  for (const char* method : {"direct", "path", "whitted"}) {
    Scene scene = floor_scene();
    scene.lights.push_back({"", PointLight{{3, 4, 0}, Intensity(Rgb(50)), {}}, -1});
    EXPECT_NEAR(illuminance_at_origin(scene, method), 50.0 / 25 * 0.8, 1e-4) << method;
    scene.lights[0].light = SpotLight{.position = {0, 2, 0}, .direction = {0, -1, 0}, .intensity = Intensity(Rgb(50))};
    EXPECT_NEAR(illuminance_at_origin(scene, method), 50.0 / 4, 1e-3) << method;
    scene.lights[0].light = DirectionalLight{{0.6f, -0.8f, 0}, Irradiance(Rgb(10))};
    EXPECT_NEAR(illuminance_at_origin(scene, method), 8, 1e-4) << method;
    scene.lights[0].light = DirectionalLight{{0, 1, 0}, Irradiance(Rgb(10))};  // from below
    EXPECT_EQ(illuminance_at_origin(scene, method), 0) << method;
  }
}

struct Luminaire {
  float width, depth, height;
  double luminance, illuminance;
  Point3 point;
  Vec3 normal;
};
// A Lambertian rectangle facing down, at known points: Lambert's formula for polygons (lambert1760), evaluated in
// double precision.
const Luminaire kLuminaires[] = {
    {1.2f, 0.6f, 2.5f, 3052.7, 335.6765220390559, {0, 0, 0}, {0, 1, 0}},
    {1.2f, 0.6f, 2.5f, 4707.3, 255.4634547375139, {1.5f, 0, -0.8f}, {0, 1, 0}},
    {2.0f, 2.0f, 1.0f, 5626.6, 543.2046997413912, {3, 0.2f, 0}, {-0.6f, 0.8f, 0}},
};

TEST(Direct, RectangularLuminaires) {
  for (const Luminaire& l : kLuminaires) {
    const float x = l.width / 2, z = l.depth / 2, y = l.height;
    Scene scene;
    test::set_matt(test::add(scene, test::quad({-x, y, -z}, {x, y, -z}, {x, y, z}, {-x, y, z})), Rgb(0),
                   Rgb(float(l.luminance)));
    const std::vector<Point3> points(200, l.point);
    const std::vector<Vec3> normals(200, l.normal);
    RunningStatistics e;
    for (const Irradiance& i : illuminance(scene, points, normals, options("direct", 64))) e.add(double(i.v.g));
    EXPECT_MEAN(e, l.illuminance);
    EXPECT_LT(e.standard_error(), 5e-3 * l.illuminance);
  }
}

TEST(Direct, SphereAndDiscLampsHaveClosedForms) {
  // E = pi L sin^2 of the half angle under which a facing disc or sphere is seen.
  Scene sphere;
  test::set_matt(test::add(sphere, Sphere{0.5f}, test::translation({0, 2, 0}) * Mat4(Mat3(2.0f))), Rgb(0), Rgb(10));
  Scene disc;
  const Mat4 down(Mat3(1, 0, 0, 0, -1, 0, 0, 0, 1));
  test::set_matt(test::add(disc, Disc{1}, test::translation({0, 2, 0}) * down), Rgb(0), Rgb(10));
  const std::vector<Point3> points(200, Point3(0));
  const std::vector<Vec3> normals(200, Vec3(0, 1, 0));
  const auto measured = [&](const Scene& scene) {
    RunningStatistics e;
    for (const Irradiance& i : illuminance(scene, points, normals, options("direct", 64))) e.add(double(i.v.g));
    return e;
  };
  EXPECT_MEAN(measured(sphere), 10 * kPi * 1 / 4);
  EXPECT_MEAN(measured(disc), 10 * kPi * 1 / 5);
}

TEST(Direct, StrategiesAgree) {
  // A lamp, a sky with a bright spot, and a rough metal: no strategy alone is good everywhere, all have the same mean.
  Scene scene = floor_scene();
  test::set_metal(scene.materials[0], Rgb(0.8f), 0.4f);
  test::set_matt(test::add(scene, test::quad({-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1})), Rgb(0), Rgb(3));
  scene.environment.radiance = Image(16, 8, 3, 0.2f);
  scene.environment.radiance.set_rgb(5, 2, Rgb(20));
  scene.environment.colour = Radiance(Rgb(1));
  const auto run = [&](const char* method) { return estimates(scene, {3, 1, 0}, {-3, -1, 0.1f}, method, 300, 64); };
  const auto joined = run("direct"), lights = run("direct:strategy=1"), scattering = run("direct:strategy=2");
  for (const auto& alone : {lights, scattering})
    EXPECT_LT(std::abs(alone.mean() - joined.mean()),
              4 * std::hypot(alone.standard_error(), joined.standard_error()) + 5e-3 * joined.mean());
  EXPECT_LT(joined.variance(), 1.2 * std::min(lights.variance(), scattering.variance()));
}

TEST(Direct, IsTheFirstBounceOfPath) {
  Scene scene = floor_scene();
  test::set_matt(test::add(scene, test::quad({-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1})), Rgb(0.5f), Rgb(3));
  const auto direct = estimates(scene, {3, 1, 0}, {-3, -1, 0.1f}, "direct", 200, 16);
  const auto path = estimates(scene, {3, 1, 0}, {-3, -1, 0.1f}, "path:depth=1", 200, 16);
  EXPECT_EQ(direct.mean(), path.mean());
}

TEST(Direct, AlphaLetsLightThrough) {
  Scene scene = floor_scene();
  scene.lights.push_back({"", DirectionalLight{{0, -1, 0}, Irradiance(Rgb(10))}, -1});
  Material& veil = test::add(scene, test::quad({-9, 1.5f, 9}, {9, 1.5f, 9}, {9, 1.5f, -9}, {-9, 1.5f, -9}));
  veil.alpha_mode = AlphaMode::blend, veil.alpha = 0.25f, veil.base_colour = Rgb(0), veil.specular_weight = 0;
  for (const char* method : {"direct", "path", "whitted"})
    EXPECT_NEAR(illuminance_at_origin(scene, method), 7.5, 1e-3) << method;
  veil.alpha_mode = AlphaMode::mask;
  for (const char* method : {"direct", "path", "whitted"})
    EXPECT_NEAR(illuminance_at_origin(scene, method), 10, 1e-3) << method;
  veil.alpha_mode = AlphaMode::opaque;
  for (const char* method : {"direct", "path", "whitted"}) EXPECT_EQ(illuminance_at_origin(scene, method), 0) << method;
}

TEST(Direct, ConstantSkyIsAFurnace) {
  Scene scene = floor_scene();
  scene.environment.colour = Radiance(Rgb(2));
  EXPECT_NEAR(illuminance_at_origin(scene, "direct"), 2 * kPi, 0.02);
  scene.environment.radiance = Image(64, 32, 3, 2);
  scene.environment.colour = Radiance(Rgb(1));
  EXPECT_NEAR(illuminance_at_origin(scene, "direct"), 2 * kPi, 0.02);
}

}  // namespace
}  // namespace aktina
