#include <gtest/gtest.h>

#include "trace/integrator/light_scenes.h"

namespace aktina {
namespace {

using test::along;
using test::options;

/// A clear slab between y = 0 and y = -thickness over a striped floor far below.
Scene slab(float index) {
  Scene scene;
  Material& m = test::add(scene, test::box({-50, -1, -50}, {50, 0, 50}));
  test::set_classic(m, {.kd = Rgb(0), .kt = Rgb(1), .index = index});
  scene.environment.radiance = Image(256, 128, 3);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x) scene.environment.radiance.set_rgb(x, y, Rgb(float(x), float(y), 1));
  scene.environment.colour = Radiance(Rgb(1));
  return scene;
}

TEST(Whitted, SlabLetsRaysOutParallel) {
  const Vec3 direction = normalize(Vec3(0.6f, -1, 0.2f));
  for (const float index : {1.0f, 1.33f, 2.0f}) {
    const Rgb seen = along(slab(index), {0, 1, 0}, direction, options("whitted:cutoff=0", 1));
    const Rgb open = radiance(slab(index).environment, direction).v;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(seen[k], open[k], 2e-3f * open[k]) << index;
  }
}

TEST(Whitted, TotalInternalReflectionFollowsItsRule) {
  // From inside a clear cube, beyond the critical angle: black or mirrored until the depth is used up.
  Scene scene;
  test::set_classic(test::add(scene, test::box(Point3(-1), Point3(1))), {.kd = Rgb(0), .kt = Rgb(1), .index = 1.5f});
  scene.background = Radiance(Rgb(1));
  const Vec3 flat = normalize(Vec3(0.3f, 0.7f, 0.75f));  // meets all six walls at more than 41.8 degrees
  const Vec3 steep = normalize(Vec3(0.05f, 1, 0.02f));
  EXPECT_EQ(along(scene, {0, 0, 0}, flat, options("whitted:tir=0,cutoff=0", 1)).g, 0);
  EXPECT_EQ(along(scene, {0, 0, 0}, steep, options("whitted:tir=0,cutoff=0", 1)).g, 1);
  EXPECT_EQ(along(scene, {0, 0, 0}, steep, options("whitted:tir=1,cutoff=0", 1)).g, 1);
}

TEST(Whitted, ParallelMirrorsGiveAGeometricSeries) {
  Scene scene;
  for (const float z : {-1.0f, 1.0f}) {
    Mesh mesh = test::quad({-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z});
    if (z > 0)
      for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    test::set_classic(test::add(scene, std::move(mesh)), {.ka = Rgb(1), .kd = Rgb(0), .kr = Rgb(0.5f)});
  }
  scene.ambient = Rgb(1);
  for (const int depth : {0, 1, 5}) {
    const std::string method = "whitted:cutoff=0,depth=" + std::to_string(depth);
    TraceStatistics statistics;
    const Ray ray{{0.1f, 0.2f, 0}, {0, 0, 1}};
    const Rgb l = trace_radiance(scene, {&ray, 1}, options(method.c_str(), 1), nullptr, &statistics)[0].v;
    EXPECT_NEAR(double(l.g), (1 - std::pow(0.5, depth + 1)) / (1 - 0.5), 1e-6);
    EXPECT_EQ(statistics.rays, uint64_t(depth) + 1) << "a mirror box of depth d has d + 1 nodes";
  }
}

TEST(Whitted, CutOffErrsWithinItsBound) {
  // One child is cut where its weight falls below eps: at most eps times the brightest node.
  Scene scene;
  Material& walls = test::add(scene, test::room(Point3(-1), Point3(1)));
  test::set_classic(walls, {.ka = Rgb(0.3f), .kd = Rgb(0.3f), .kr = Rgb(0.6f)});
  scene.ambient = Rgb(1);
  uint64_t before = ~uint64_t(0);
  const Ray ray{{0.1f, 0.2f, 0}, normalize(Vec3(0.3f, 0.5f, 0.9f))};
  const float exact = trace_radiance(scene, {&ray, 1}, options("whitted:cutoff=0,depth=64", 1))[0].v.g;
  for (const double eps : {0.0001, 0.001, 0.01, 0.1, 1.0}) {
    const std::string method = "whitted:depth=64,cutoff=" + std::to_string(eps);
    TraceStatistics statistics;
    const float cut = trace_radiance(scene, {&ray, 1}, options(method.c_str(), 1), nullptr, &statistics)[0].v.g;
    EXPECT_LE(std::abs(cut - exact), eps * 0.3 / (1 - 0.6) + 1e-6);
    EXPECT_LE(statistics.rays, before);
    before = statistics.rays;
  }
  EXPECT_EQ(before, 1U);
}

TEST(Whitted, ShadowsOfClearBodiesFollowTheirRule) {
  Scene scene;
  test::set_matt(test::add(scene, test::quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9})), Rgb(1));
  test::set_classic(test::add(scene, Sphere{0.5f}, test::translation({0, 1, 0})), {.kd = Rgb(0), .kt = Rgb(0.8f)});
  scene.lights.push_back({"", DirectionalLight{{0, -1, 0}, Irradiance(Rgb(float(kPi)))}, -1});
  const auto floor_at = [&](float x, const char* method) {
    return along(scene, {x + 1, 0.1f, 0}, {-1, -0.1f, 0}, options(method, 1)).g;
  };
  EXPECT_NEAR(floor_at(2, "whitted"), 1, 1e-5);
  EXPECT_NEAR(floor_at(0, "whitted"), 0.8, 1e-5) << "kt once, though the ray crosses the sphere twice";
  EXPECT_EQ(floor_at(0, "whitted:shadows=0"), 0);
}

TEST(Whitted, ReachFadesMirrorsInProportion) {
  Scene scene;
  test::set_classic(test::add(scene, test::quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9})),
                    {.kd = Rgb(0), .kr = Rgb(1)});
  Material& lamp = test::add(scene, test::quad({-9, 4, -9}, {9, 4, -9}, {9, 4, 9}, {-9, 4, 9}));
  test::set_matt(lamp, Rgb(0), Rgb(1));
  EXPECT_NEAR(along(scene, {0, 1, 0}, {0, -1, 0}, options("whitted", 1)).g, 1, 1e-6);
  EXPECT_NEAR(along(scene, {0, 1, 0}, {0, -1, 0}, options("whitted:reach=10", 1)).g, 0.6, 1e-5);
  EXPECT_EQ(along(scene, {0, 1, 0}, {0, -1, 0}, options("whitted:reach=3", 1)).g, 0);
}

TEST(Whitted, GrazingRaysDoNotMeetTheirOwnSurface) {
  for (const float far : {0.0f, 1000.0f, 100000.0f}) {
    Scene scene;
    const float x = far;
    test::set_matt(test::add(scene, test::quad({x - 9, far, 9}, {x + 9, far, 9}, {x + 9, far, -9}, {x - 9, far, -9})),
                   Rgb(1));
    test::set_matt(test::add(scene, Sphere{1}, test::translation({x + 3, far + 1.5f, 0})), Rgb(1));
    scene.lights.push_back({"", DirectionalLight{normalize(Vec3(1, -0.02f, 0)), Irradiance(Rgb(1))}, -1});
    int lit = 0;
    for (int i = 0; i < 200; ++i) {
      const float z = -8 + 0.08f * float(i);
      lit += along(scene, {x - 5, far + 2, z}, {0.1f, -1, 0}, options("whitted", 1)).g > 0;
    }
    EXPECT_EQ(lit, 200) << "at " << far;
  }
}

TEST(Whitted, AgreesWithPathTracingWithoutMattBounces) {
  // A matt floor under point lamps beside a mirror: path tracing to depth 2 sees lamp -> floor -> mirror -> eye too.
  Scene scene;
  test::set_matt(test::add(scene, test::quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9})), Rgb(0.6f));
  Material& mirror = test::add(scene, test::quad({2, 0, -3}, {2, 0, 3}, {2, 4, 3}, {2, 4, -3}));
  test::set_classic(mirror, {.ka = Rgb(0), .kd = Rgb(0), .kr = Rgb(0.9f)});
  mirror.roughness = 0;
  scene.lights.push_back({"", PointLight{{0, 3, 1}, Intensity(Rgb(20)), {}}, -1});
  for (const float y : {0.35f, 0.4f, 0.5f}) {
    const Vec3 direction = normalize(Vec3(1, -y, 0.1f));
    const Rgb whitted = along(scene, {-2, 2.5f, 0}, direction, options("whitted", 1));
    const Rgb path = along(scene, {-2, 2.5f, 0}, direction, options("path:depth=2", 1));
    EXPECT_GT(whitted.g, 0);
    EXPECT_NEAR(whitted.g, path.g, 2e-3f * whitted.g) << y;
  }
}

TEST(Whitted, EmissiveSurfacesCastLightAndNoShadowOfTheirOwn) {
  Scene scene;
  test::set_matt(test::add(scene, test::quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9})), Rgb(1));
  const float a = 0.05f;
  test::set_matt(test::add(scene, test::quad({-a, 2, -a}, {a, 2, -a}, {a, 2, a}, {-a, 2, a})), Rgb(0), Rgb(1000));
  const double e = kPi * double(along(scene, {0.3f, 1, 0.2f}, {-0.3f, -1, -0.2f}, options("whitted", 1)).g);
  EXPECT_NEAR(e, 1000 * 4 * double(a * a) / 4, 0.05) << "L A / d^2 of a small lamp";
  test::add(scene, Sphere{0.2f}, test::translation({0, 1, 0}));
  EXPECT_EQ(along(scene, {0.8f, 0.5f, 0}, {-0.8f, -0.5f, 0}, options("whitted", 1)).g, 0);
}

}  // namespace
}  // namespace aktina
