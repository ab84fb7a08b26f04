// Discontinuity meshing: what the paper promises of its fragments, held by shadow rays.
#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "aktina/base/random.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/mesher/patch_builder.h"
#include "aktina/radiosity/mesher/shadow_lines.h"
#include "aktina/radiosity/solver/visibility.h"
#include "aktina/scene/weld.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

PatchMesh discontinuity(const Scene& scene, double size, Warnings* warnings = nullptr) {
  Warnings unused;
  return make_method(meshers(), "mesher", "discontinuity")
      ->mesh(scene, {.patch_size = size}, warnings ? *warnings : unused);
}

Scene furnished() {
  Scene scene = room({4, 2.5f, 3}, Rgb(0.5f));
  add_box(scene, {1.1f, 0.4f, 0.9f}, {0.8f, 0.3f, 0.7f}, Rgb(0.5f));
  add_box(scene, {2.3f, 0, 1.7f}, {0.5f, 0.9f, 0.4f}, Rgb(0.5f));
  return scene;
}

/// A place well within a patch.
Point3 place(const PatchMesh& mesh, size_t i, Pcg32& random) {
  const auto& c = mesh.patches[i];
  const float u = 0.05f + 0.9f * random.uniform(), v = 0.05f + 0.9f * random.uniform();
  const auto p = [&](size_t k) { return mesh.positions[c[k]]; };
  if (mesh.is_quad(i)) return (p(0) * (1 - u) + p(1) * u) * (1 - v) + (p(3) * (1 - u) + p(2) * u) * v;
  const float a = 0.05f + 0.85f * u, b = (0.95f - a) * (0.1f + 0.8f * v);
  return p(0) * (1 - a - b) + p(1) * a + p(2) * b;
}

/// How many of 100 places on a patch see a point.
int lit(const Visibility& visibility, const PatchMesh& mesh, size_t i, Point3 lamp) {
  Pcg32 random(i);
  int count = 0;
  for (int k = 0; k < 100; ++k) {
    const Point3 x = place(mesh, i, random);
    RayPacket rays{};
    float shares[kPacket];
    rays.set(0, visibility.towards(x, mesh.patch_normals[i], normalize(lamp - x), length(lamp - x)));
    visibility.passing(rays, 1, Coherence::incoherent, shares);
    count += shares[0] > 0;
  }
  return count;
}

bool thin(const PatchMesh& mesh, size_t i) {
  Bounds box;
  for (const uint32_t v : mesh.patches[i]) box.add(mesh.positions[v]);
  return mesh.areas[i] < 2e-3f * box.diagonal();
}

/// @param rim  edges of surfaces that end in the air
void expect_whole(const Scene& scene, const PatchMesh& mesh, size_t rim) {
  const double area = SceneFaces(scene).area();
  EXPECT_NEAR(std::accumulate(mesh.areas.begin(), mesh.areas.end(), 0.0), area, 1e-4 * area);
  const std::vector<uint32_t> same = weld(mesh.positions);
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (size_t i = 0; i < mesh.size(); ++i) {
    const auto& p = mesh.patches[i];
    const size_t n = mesh.is_quad(i) ? 4 : 3;
    for (size_t k = 0; k < n; ++k) ++edges[std::minmax(same[p[k]], same[p[(k + 1) % n]])];
  }
  size_t odd = 0;
  for (const auto& [edge, count] : edges) odd += count % 2;
  EXPECT_EQ(odd, rim) << "a crack or a T-junction";
}

TEST(Discontinuity, EachPatchIsWhollyLitOrDarkByAPointLight) {
  Scene scene = furnished();
  const Point3 lamp(1.63f, 2.2f, 1.27f);
  scene.lights.emplace_back().light = PointLight{lamp};
  const Visibility visibility(scene);
  const PatchMesh mesh = discontinuity(scene, 0.4);
  size_t mixed = 0, dark = 0;
  for (size_t i = 0; i < mesh.size(); ++i) {
    if (thin(mesh, i) || dot(lamp - mesh.positions[mesh.patches[i][0]], mesh.patch_normals[i]) < 1e-3f) continue;
    const int count = lit(visibility, mesh, i, lamp);
    mixed += count > 0 && count < 100;
    dark += count == 0;
  }
  EXPECT_EQ(mixed, 0U);
  EXPECT_GT(dark, 5U);
  expect_whole(scene, mesh, 0);
}

TEST(Discontinuity, PatchesOutsideThePenumbraSeeAllOfAPanel) {
  Scene scene = furnished();
  add_quad(scene, {1.4f, 2.4f, 1.2f}, {0.5f, 0, 0}, {0, 0, 0.4f}, Rgb(0.1f), Rgb(100));
  const Visibility visibility(scene);
  const PatchMesh mesh = discontinuity(scene, 0.3);
  Point3 corners[4];  // hardly within the panel
  for (int c = 0; c < 4; ++c) corners[c] = {c == 0 || c == 3 ? 1.401f : 1.899f, 2.399f, c < 2 ? 1.201f : 1.599f};
  size_t umbra = 0, lit_ones = 0, penumbra = 0;
  for (size_t i = 0; i < mesh.size(); ++i) {
    if (mesh.centres[i].instance != 0 || thin(mesh, i)) continue;  // the floor
    Pcg32 random(i);
    int whole = 0, none = 0;
    for (int k = 0; k < 40; ++k) {
      const Point3 x = place(mesh, i, random);
      RayPacket rays{};
      float shares[kPacket];
      for (int c = 0; c < 4; ++c)
        rays.set(c, visibility.towards(x, {0, 1, 0}, normalize(corners[c] - x), length(corners[c] - x)));
      visibility.passing(rays, 15, Coherence::incoherent, shares);
      const float sum = shares[0] + shares[1] + shares[2] + shares[3];
      whole += sum == 4, none += sum == 0;
    }
    if (whole >= 38)
      ++lit_ones;
    else if (none >= 38)
      ++umbra;
    else {
      ++penumbra;
      EXPECT_LE(whole, 4) << "partly outside of the penumbra";
    }
  }
  EXPECT_GT(lit_ones, 20U);
  EXPECT_GT(penumbra, 5U);
  EXPECT_GT(umbra, 0U);
  expect_whole(scene, mesh, 8);
}

TEST(Discontinuity, ShadowOfASquareFromAPointAboveItHasKnownSize) {
  const FacePolygon occluder = {{-1, 1, -1}, {-1, 1, 1}, {1, 1, 1}, {1, 1, -1}};
  const ShadowVolume volume = shadow_volume(occluder, {{0, 2, 0}}, true, 1e-9);
  ASSERT_EQ(volume.planes.size(), 4U);
  for (const auto& plane : volume.planes) {
    EXPECT_LT(dot(plane.normal, Vec3d(1.99, 0, 1.99)) - plane.offset, 1e-9)
        << "twice the square, at twice the distance";
    EXPECT_LT(dot(plane.normal, Vec3d(-1.99, 0, -1.99)) - plane.offset, 1e-9);
  }
}

TEST(Discontinuity, ManyFacesAreNotComparedAndThatIsCounted) {
  Scene scene = furnished();
  scene.lights.emplace_back().light = PointLight{{1, 2, 1}};
  for (int i = 0; i < 1500; ++i) add_quad(scene, {0.02f * float(i), 3, 0}, {0, 0, 0.01f}, {0.01f, 0, 0}, Rgb(0.5f));
  Warnings warnings;
  discontinuity(scene, 0.5, &warnings);
  ASSERT_FALSE(warnings.empty());
  EXPECT_EQ(warnings.items()[0].count, 1U);
}

}  // namespace
}  // namespace aktina
