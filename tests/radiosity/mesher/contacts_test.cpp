// Contact lines: no patch of any mesh lies on both sides of another surface.
#include "aktina/radiosity/mesher/contacts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "aktina/base/random.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/scene/weld.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

PatchMesh uniform(const Scene& scene, double size, Warnings* warnings = nullptr) {
  Warnings unused;
  return make_method(meshers(), "mesher", "uniform")->mesh(scene, {.patch_size = size}, warnings ? *warnings : unused);
}

double total_area(const PatchMesh& mesh) { return std::accumulate(mesh.areas.begin(), mesh.areas.end(), 0.0); }

/// Patches that are not thin, a little smaller than they are: what touches only their edges does not count.
std::vector<FlatFace> shrunk(const PatchMesh& mesh, float thin) {
  std::vector<FlatFace> faces;
  for (size_t i = 0; i < mesh.size(); ++i) {
    FlatFace f{0, 0, {}, Vec3d(mesh.patch_normals[i]), 0, {}};
    Point3 centre(0);
    for (const uint32_t v : mesh.patches[i]) centre += 0.25f * mesh.positions[v];
    for (size_t k = 0; k < (mesh.is_quad(i) ? 4U : 3U); ++k) {
      const Point3 p = centre + 0.98f * (mesh.positions[mesh.patches[i][k]] - centre);
      f.corners.emplace_back(p);
      f.box.add(p);
    }
    if (mesh.areas[i] < thin * f.box.diagonal()) continue;
    f.offset = dot(f.normal, f.corners[0]);
    faces.push_back(f);
  }
  return faces;
}

/// Cracks and T-junctions leave edges of one patch only; where surfaces meet an edge belongs to two from each.
void expect_closed(const PatchMesh& mesh) {
  const std::vector<uint32_t> same = weld(mesh.positions);
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (size_t i = 0; i < mesh.size(); ++i) {
    const auto& p = mesh.patches[i];
    const size_t n = mesh.is_quad(i) ? 4 : 3;
    for (size_t k = 0; k < n; ++k) ++edges[std::minmax(same[p[k]], same[p[(k + 1) % n]])];
  }
  size_t odd = 0;
  for (const auto& [edge, count] : edges) odd += count % 2;
  EXPECT_EQ(odd, 0U);
}

/// A turned box, anywhere: bodies that go through each other.
void add_turned_box(Scene& scene, Pcg32& random) {
  const size_t first = scene.instances.size();
  add_box(scene, Point3(-0.5f), Vec3(1), Rgb(0.5f));
  const auto number = [&] { return random.uniform(); };
  const Frame frame(normalize_or(Vec3(number(), number(), number()) - 0.5f, {0, 1, 0}));
  const Vec3 size(0.2f + number(), 0.2f + number(), 0.2f + number());
  Mat4 m(Vec4(frame.t * size.x, 0), Vec4(frame.b * size.y, 0), Vec4(frame.n * size.z, 0), Vec4(0, 0, 0, 1));
  m[3] = Vec4(number(), number(), number(), 1);
  for (size_t i = first; i < scene.instances.size(); ++i) scene.instances[i].to_world = m;
}

TEST(Contacts, ABoxOnTheFloorCutsItAlongItsFootprint) {
  Scene scene = room({4, 2.5f, 3}, Rgb(0.5f));
  add_box(scene, {1.13f, 0, 0.71f}, {0.83f, 1, 0.59f}, Rgb(0.5f));
  for (const double size : {0.11, 0.4, 5.0}) {
    const PatchMesh mesh = uniform(scene, size);
    double under = 0;
    for (size_t i = 0; i < mesh.size(); ++i) {
      if (mesh.centres[i].instance != 0) continue;
      float low[2] = {1e9f, 1e9f}, high[2] = {-1e9f, -1e9f};
      for (const uint32_t v : mesh.patches[i])
        for (int c = 0; c < 2; ++c) {
          low[c] = std::min(low[c], mesh.positions[v][2 * c]), high[c] = std::max(high[c], mesh.positions[v][2 * c]);
        }
      const float e = 1e-5f;
      const bool inside = low[0] > 1.13f - e && high[0] < 1.96f + e && low[1] > 0.71f - e && high[1] < 1.3f + e;
      const bool outside = high[0] < 1.13f + e || low[0] > 1.96f - e || high[1] < 0.71f + e || low[1] > 1.3f - e;
      EXPECT_TRUE(inside || outside || mesh.areas[i] < 0.25f * 0.83f * 0.59f) << "half under the box";
      if (inside) under += double(mesh.areas[i]);
    }
    EXPECT_NEAR(under, 0.83 * 0.59, 1e-5);
    expect_closed(mesh);
  }
}

TEST(Contacts, NoPatchIsLeftOnBothSidesOfASurface) {
  for (uint32_t seed = 0; seed < 40; ++seed) {
    Pcg32 random(seed);
    Scene scene = room({1.5f, 1.2f, 1.4f}, Rgb(0.5f));
    for (int k = 0; k < 5; ++k) add_turned_box(scene, random);
    const SceneFaces before(scene);
    const PatchMesh mesh = uniform(scene, 0.3);
    EXPECT_NEAR(total_area(mesh), before.area(), 1e-4 * before.area());
    expect_closed(mesh);
    bool too_many = true;
    const auto lines = find_contacts(shrunk(mesh, 0.01f), 1e-9, 0.3 / 16, &too_many);
    EXPECT_TRUE(lines.empty()) << lines.size() << " lines of contact are left, seed " << seed;
    EXPECT_FALSE(too_many);
  }
}

TEST(Contacts, WhatEndsOnAnEdgeCutsNothing) {
  const Scene scene = room({2, 1, 1}, Rgb(0.5f));
  EXPECT_EQ(uniform(scene, 10).size(), 6U);
}

TEST(Contacts, AWallThroughTheFloorCutsBoth) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {0, 0, 2}, {2, 0, 0}, Rgb(0.5f));
  add_quad(scene, {0.7f, -1, -1}, {0, 2, 0}, {0, 0, 4}, Rgb(0.5f));
  const PatchMesh mesh = uniform(scene, 10);
  double left = 0, below = 0;
  for (size_t i = 0; i < mesh.size(); ++i) {
    const auto all = [&](int axis, float from, float to) {
      return std::all_of(mesh.patches[i].begin(), mesh.patches[i].end(), [&](uint32_t v) {
        return mesh.positions[v][axis] > from - 1e-5f && mesh.positions[v][axis] < to + 1e-5f;
      });
    };
    if (mesh.centres[i].instance == 0 && all(0, 0, 0.7f)) left += double(mesh.areas[i]);
    if (mesh.centres[i].instance == 1 && all(1, -1, 0)) below += double(mesh.areas[i]);
  }
  EXPECT_NEAR(left, 1.4, 1e-5);
  EXPECT_NEAR(below, 4, 1e-5);
}

TEST(Contacts, OfShortLinesTheShortestAreLeftOutAndCounted) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {0, 0, 20}, {20, 0, 0}, Rgb(0.5f));
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 20; ++k)
      add_box(scene, {0.2f + 0.9f * float(i), 0, 0.2f + 0.9f * float(k)}, Vec3(0.5f), Rgb(0.5f));
  Warnings warnings;
  const PatchMesh mesh = uniform(scene, 4, &warnings);
  ASSERT_EQ(warnings.items().size(), 1U);
  EXPECT_THAT(warnings.items()[0].text, testing::HasSubstr("contact"));
  EXPECT_EQ(warnings.items()[0].count, 400U * 8) << "each edge of a footprint belongs to two faces of its box";
  EXPECT_LT(mesh.size(), 3000U);
  Warnings none;
  EXPECT_GT(uniform(scene, 1, &none).size(), 3500U);
  EXPECT_TRUE(none.empty()) << none.items()[0].text << none.items()[0].count;
}

TEST(Contacts, ManySurfacesInOnePlaceAreNotComparedAllWithAll) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, Rgb(0.5f));
  for (int i = 0; i < 12'000; ++i) scene.instances.push_back(scene.instances[0]);
  Warnings warnings;
  EXPECT_EQ(uniform(scene, 10, &warnings).size(), 12'001U);
  EXPECT_FALSE(warnings.empty());
}

}  // namespace
}  // namespace aktina
