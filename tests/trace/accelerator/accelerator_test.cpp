#include "aktina/trace/accelerator/accelerator.h"

#include <gtest/gtest.h>

#include "aktina/base/error.h"
#include "aktina/base/random.h"
#include "trace/test_scenes.h"

namespace aktina {
namespace {

std::unique_ptr<Accelerator> built(const char* id, const Scene& scene) {
  auto accelerator = make_method(accelerators(), "accelerator", id);
  accelerator->build(scene);
  return accelerator;
}

Vec3 random_point(Pcg32& random, float extent) {
  return extent * Vec3(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1);
}

/// A ball placed twice (shared), a mirrored and a squeezed box, and one primitive of each kind.
Scene mixed_scene() {
  Scene scene;
  test::add(scene, test::bumpy_ball(24), test::translation({-1, 0, 0}));
  Instance again = scene.instances.back();
  again.to_world = test::translation({1.5f, 0.3f, 0}) * Mat4(Mat3(0.5f, 0.2f, 0, -0.3f, 1, 0, 0, 0, 0.7f));
  scene.instances.push_back(again);
  test::add(scene, test::box(Point3(-0.4f), Point3(0.4f)),
            test::translation({0, 1.5f, 0}) * Mat4(Mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1)));
  test::add(scene, test::box(Point3(-0.4f), Point3(0.4f)),
            test::translation({0, -1.5f, 1}) * Mat4(Mat3(2, 0, 0, 0, 0.1f, 0, 0, 0, 1)));
  test::add(scene, Sphere{0.6f}, test::translation({0.2f, 0, 1.2f}));
  test::add(scene, Disc{0.8f}, test::translation({0, 0.9f, -1}) * Mat4(Mat3(1, 0.3f, 0, 0, 1, 0, 0.2f, 0, 1)));
  test::add(scene, Cylinder{0.3f, 1}, test::translation({1, -1, -1}));
  test::add(scene, Cone{0.4f, 0.1f, 1}, test::translation({-1, -1, -1}));
  return scene;
}

TEST(Accelerator, EmbreeAndBruteForceAgree) {
  const Scene scene = mixed_scene();
  const auto embree = built("embree", scene), brute = built("brute_force", scene);
  Pcg32 random(1);
  int hits = 0, differences = 0;
  for (int packet = 0; packet < 4000; ++packet) {
    RayPacket rays;
    HitPacket a, b;
    for (int lane = 0; lane < kPacket; ++lane) {
      const Point3 from = random_point(random, 3);
      rays.set(lane, {from, random_point(random, 1.5f) - from, 0, packet % 2 ? kInfinity : 1});
    }
    embree->intersect(rays, kAllLanes, a, Coherence::incoherent);
    brute->intersect(rays, kAllLanes, b, packet % 3 ? Coherence::coherent : Coherence::incoherent);
    const uint32_t hidden_a = embree->occluded(rays, kAllLanes, Coherence::incoherent);
    const uint32_t hidden_b = brute->occluded(rays, kAllLanes, Coherence::incoherent);
    for (int lane = 0; lane < kPacket; ++lane) {
      const Hit x = a.at(lane), y = b.at(lane);
      ASSERT_EQ(hidden_a >> lane & 1, uint32_t(bool(x))) << "closest hit and occlusion agree within Embree";
      ASSERT_EQ(hidden_b >> lane & 1, uint32_t(bool(y))) << "and within brute force";
      if (x.instance != y.instance || (x && x.triangle != y.triangle)) {
        ++differences;  // a ray that touches an edge or the interval's end
        continue;
      }
      if (!x) continue;
      ++hits;
      EXPECT_NEAR(x.distance, y.distance, 1e-4f * (1 + x.distance));
      EXPECT_NEAR(x.u, y.u, 1e-3f);
      EXPECT_NEAR(x.v, y.v, 1e-3f);
      EXPECT_GT(dot(normalize(x.normal), normalize(y.normal)), 0.9999f);
    }
  }
  EXPECT_GT(hits, 20000);
  EXPECT_LT(differences, 20);
}

TEST(Accelerator, FrontsLookOutwardHoweverTheMeshIsPlaced) {
  // From outside, every first hit of a closed body must be on a front; also where the instance mirrors it.
  const Scene scene = mixed_scene();
  Pcg32 random(3);
  for (const char* id : {"embree", "brute_force"}) {
    const auto accelerator = built(id, scene);
    for (int i = 0; i < 4000; ++i) {
      const Point3 from = 10.0f * normalize(random_point(random, 1));
      const Ray ray = {from, random_point(random, 1.5f) - from};
      const Hit hit = accelerator->intersect(ray);
      if (!hit || hit.instance >= 4) continue;
      EXPECT_LT(dot(hit.normal, ray.direction), 0) << id << " instance " << hit.instance;
    }
  }
}

TEST(Accelerator, OnlyWantedLanesAreTouched) {
  const Scene scene = mixed_scene();
  for (const char* id : {"embree", "brute_force"}) {
    const auto accelerator = built(id, scene);
    RayPacket rays;
    HitPacket hits;
    for (int lane = 0; lane < kPacket; ++lane) {
      rays.set(lane, {{-1, 0, 5}, {0, 0, -1}});
      Hit marker;
      marker.distance = -7;
      hits.set(lane, marker);
    }
    accelerator->intersect(rays, 0x0f31, hits, Coherence::coherent);
    EXPECT_EQ(accelerator->occluded(rays, 0x0f31, Coherence::coherent), 0x0f31U);
    for (int lane = 0; lane < kPacket; ++lane)
      EXPECT_EQ(hits.distance[lane] == -7, (0x0f31 >> lane & 1) == 0) << id << " lane " << lane;
  }
}

TEST(Accelerator, NoRaySlipsOutOfAClosedBody) {
  // Rays from inside, aimed at points of edges as exactly as floats allow. Exactly at a vertex the signs of all the
  // edges that meet there may agree by rounding: rare even there.
  Scene scene;
  test::add(scene, test::bumpy_ball(20));
  const Mesh& mesh = scene.meshes[0];
  Pcg32 random(4);
  for (const char* id : {"embree", "brute_force"}) {
    const auto accelerator = built(id, scene);
    int edges_missed = 0, vertices_missed = 0;
    for (int i = 0; i < 50000; ++i) {
      const auto& t = mesh.triangles[random.next() % mesh.triangles.size()];
      const float w = i % 5 == 0 ? 0 : 0.02f + 0.96f * random.uniform();
      const Point3 target = mesh.positions[t[0]] * (1 - w) + mesh.positions[t[1]] * w;
      const Point3 from = random_point(random, 0.3f);
      (w == 0 ? vertices_missed : edges_missed) += !accelerator->intersect(Ray{from, target - from});
    }
    EXPECT_EQ(edges_missed, 0) << id;
    EXPECT_LT(vertices_missed, 100) << id << ", of 10,000";
  }
}

TEST(Accelerator, EndsOfTheIntervalAreOutside) {
  Scene scene;
  test::add(scene, test::box(Point3(-1), Point3(1)));
  for (const char* id : {"embree", "brute_force"}) {
    const auto accelerator = built(id, scene);
    EXPECT_FALSE(accelerator->occluded(Ray{{0.1f, 0.2f, 3}, {0, 0, -1}, 0, 1.999f})) << id;
    EXPECT_TRUE(accelerator->occluded(Ray{{0.1f, 0.2f, 3}, {0, 0, -1}, 0, 2.001f})) << id;
    EXPECT_NEAR(accelerator->intersect(Ray{{0.1f, 0.2f, 3}, {0, 0, -1}, 2.001f}).distance, 4, 1e-5) << id;
  }
}

TEST(Accelerator, HostileGeometryDoesNoHarm) {
  Scene scene;
  Mesh mesh = test::box(Point3(-1), Point3(1));
  const float bad[] = {NAN, INFINITY, -INFINITY, 3e38f, 1e-40f, 0};
  for (const float x : bad)
    for (const float y : bad) {
      const auto first = uint32_t(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), {{x, y, 9}, {y, x, 9}, {0, 0, x}});
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
  mesh.triangles.push_back({0, 0, 0});
  test::add(scene, std::move(mesh));
  scene.meshes.emplace_back();  // empty
  Instance empty;
  empty.mesh = 1;
  scene.instances.push_back(empty);
  scene.instances.emplace_back();  // nothing at all
  test::add(scene, Sphere{1}, Mat4(0));
  for (const char* id : {"embree", "brute_force"}) {
    const auto accelerator = built(id, scene);
    const Hit hit = accelerator->intersect(Ray{{0.3f, 0.2f, 3}, {0, 0, -1}});
    EXPECT_NEAR(hit.distance, 2, 1e-5) << id;
    for (const float x : bad)
      for (const float y : bad) {
        const Hit any = accelerator->intersect(Ray{{x, y, 0}, {y, 1, x}});
        EXPECT_TRUE(!any || !std::isnan(any.distance)) << id;
      }
  }
}

TEST(Accelerator, EmptySceneAndWrongIndices) {
  Scene scene;
  EXPECT_FALSE(build_accelerator(scene)->intersect(Ray{{0, 0, 0}, {0, 0, 1}}));
  Mesh mesh = test::box(Point3(-1), Point3(1));
  mesh.triangles.push_back({0, 1, 1000});
  test::add(scene, std::move(mesh));
  for (const char* id : {"embree", "brute_force"}) EXPECT_THROW(built(id, scene), Error) << id;
}

}  // namespace
}  // namespace aktina
