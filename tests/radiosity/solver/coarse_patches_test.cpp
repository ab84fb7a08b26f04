#include "aktina/radiosity/solver/coarse_patches.h"

#include <gtest/gtest.h>

#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solver/interpolate.h"
#include "aktina/radiosity/solver/shooter_hits.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

PatchMesh mesh_of(const Scene& scene, double size, double coarse) {
  Warnings warnings;
  return make_method(meshers(), "mesher", "uniform")->mesh(scene, {.patch_size = size, .coarse = coarse}, warnings);
}

Scene room_with_box() {
  Scene scene = room({2, 2, 2}, Rgb(0.6f));
  add_box(scene, {0.5f, 0, 0.5f}, {0.6f, 0.8f, 0.6f}, Rgb(0.7f));
  return scene;
}

TEST(CoarsePatches, EachSideIsInOneAndAreasAddUp) {
  const Scene scene = room_with_box();
  const PatchMesh mesh = mesh_of(scene, 0.1, 1);
  const Sides sides(mesh);
  const std::vector<float> open(sides.size(), 1);
  const CoarsePatches patches(sides, 0.25, open, Visibility(scene));
  EXPECT_LT(patches.size(), sides.size() / 3);
  std::vector<int> count(sides.size(), 0);
  double area = 0;
  for (size_t i = 0; i < patches.size(); ++i) {
    area += patches.area(i);
    for (const uint32_t s : patches.sides(i)) {
      ++count[s];
      EXPECT_EQ(patches.patch_of_side(s), i);
      EXPECT_GT(dot(sides.normal(s), patches.normal(i)), 0.8f);
      EXPECT_LT(length(sides.centre(s) - patches.centre(i)), 0.4f);
    }
  }
  EXPECT_EQ(count, std::vector<int>(sides.size(), 1));
  EXPECT_NEAR(area, 24 + 2 * 0.36 + 4 * 0.48, 1e-4);
}

TEST(CoarsePatches, PlacesAreSpreadEvenly) {
  const Scene scene = room_with_box();
  const PatchMesh mesh = mesh_of(scene, 0.1, 2);
  const Sides sides(mesh);
  const std::vector<float> open(sides.size(), 1);
  const CoarsePatches patches(sides, 0.5, open, Visibility(scene));
  size_t largest = 0;
  for (size_t i = 0; i < patches.size(); ++i)
    if (patches.sides(i).size() > patches.sides(largest).size()) largest = i;
  const auto members = patches.sides(largest);
  ASSERT_GT(members.size(), 4U);
  std::vector<double> share(sides.size(), 0);
  for (int k = 0; k < 1000; ++k) share[patches.place(largest, {(float(k) + 0.5f) / 1000, 0.3f}).side] += 1e-3;
  for (const uint32_t s : members) EXPECT_NEAR(share[s], double(mesh.areas[s]) / patches.area(largest), 2e-3);
}

TEST(CoarsePatches, ShelvesInOneCellStayApart) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {0, 0, 0.5f}, {0.5f, 0, 0}, Rgb(0.5f));
  Mesh& mesh = scene.meshes[0];  // a second shelf in the same mesh
  for (int k = 0; k < 4; ++k) {
    mesh.positions.push_back(mesh.positions[size_t(k)] + Vec3(0, 0.02f, 0));
    mesh.normals.push_back(mesh.normals[0]), mesh.uv[0].push_back(mesh.uv[0][size_t(k)]);
  }
  mesh.triangles.push_back({4, 5, 6}), mesh.triangles.push_back({4, 6, 7});
  const PatchMesh patch_mesh = mesh_of(scene, 0.1, 1);
  const Sides sides(patch_mesh);
  const std::vector<float> open(sides.size(), 1);
  const CoarsePatches patches(sides, 10, open, Visibility(scene));
  EXPECT_EQ(patches.size(), 2U);
}

TEST(CoarsePatches, AWallKeepsThemApart) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, Rgb(0.5f));
  add_quad(scene, {0.43f, 0, 0}, {0, 0, 1}, {0, 1, 0}, Rgb(0.5f));
  scene.materials[1].double_sided = true;
  const PatchMesh mesh = mesh_of(scene, 0.05, 1);
  const Sides sides(mesh);
  const std::vector<float> open(sides.size(), 1);
  const CoarsePatches patches(sides, 0.3, open, Visibility(scene));
  for (size_t i = 0; i < patches.size(); ++i)
    for (const uint32_t s : patches.sides(i))
      if (mesh.centres[sides.patch(s)].instance == 0) {
        EXPECT_EQ(sides.centre(s).x < 0.43f, patches.centre(i).x < 0.43f) << sides.centre(s).x;
      }
}

TEST(ShooterHits, WhatStandsUnderABoxIsBuried) {
  const Scene scene = room_with_box();
  const PatchMesh mesh = mesh_of(scene, 0.1, 2);
  const Sides sides(mesh);
  const std::vector<float> open = ShooterHits(sides).open_shares();
  for (size_t s = 0; s < sides.size(); ++s) {
    const Point3 c = sides.centre(s);
    const bool under =
        c.y < 1e-4f && std::abs(c.x - 0.8f) < 0.3f && std::abs(c.z - 0.8f) < 0.3f && sides.normal(s).y > 0;
    const bool bottom = mesh.centres[s].instance == 7;  // of the box, on the floor
    if (bottom) continue;
    EXPECT_EQ(open[s], under ? 0 : 1) << c.x << ' ' << c.y << ' ' << c.z;
  }
}

/// Boxes of 1 cm on a floor of 2 m, 2 cm apart.
Scene many_boxes() {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {0, 0, 2}, {2, 0, 0}, Rgb(0.5f));
  for (int i = 0; i < 24; ++i)
    for (int k = 0; k < 24; ++k)
      add_box(scene, {0.8f + 0.02f * float(i), 0, 0.8f + 0.02f * float(k)}, {0.01f, 0.01f, 0.01f}, Rgb(0.5f));
  return scene;
}

TEST(CoarsePatches, SmallThingsAreTakenTogetherButNotThroughAWall) {
  Scene scene = many_boxes();
  const float wall = 1.035f;
  add_quad(scene, {wall, 0, 0}, {0, 0, 2}, {0, 1, 0}, Rgb(0.4f));
  add_quad(scene, {wall, 0, 0}, {0, 1, 0}, {0, 0, 2}, Rgb(0.4f));
  const PatchMesh mesh = mesh_of(scene, 0.25, 1);
  const Sides sides(mesh);
  const std::vector<float> open = ShooterHits(sides).open_shares();
  const CoarsePatches patches(sides, 0.5, open, Visibility(scene));
  EXPECT_GT(sides.size(), 24 * 24 * 6U);
  EXPECT_LT(patches.size(), sides.size() / 7);
  for (size_t i = 0; i < patches.size(); ++i) {
    const bool bottom = patches.normal(i).y < -0.9f;  // lies on the floor: hidden, and nothing is below
    if (bottom || patches.buried(i) || std::abs(patches.centre(i).x - wall) < 1e-4f) continue;
    Bounds box;
    for (const uint32_t s : patches.sides(i)) {
      EXPECT_GT(dot(sides.normal(s), patches.normal(i)), 0.99f);
      EXPECT_EQ(sides.centre(s).x < wall, patches.centre(i).x < wall);
      box.add(sides.centre(s));
    }
    const double between = patches.sides(i).size() > 1 ? double(box.diagonal()) : 0;
    EXPECT_GE(patches.extent(i), 0.9 * between / std::sqrt(2.0));
  }
}

TEST(ShooterHits, ShareThatManySmallBoxesLeaveOpen) {
  const Scene scene = many_boxes();
  const PatchMesh mesh = mesh_of(scene, 0.25, 1);
  const Sides sides(mesh);
  const std::vector<float> open = ShooterHits(sides).open_shares();
  double floor = 0;
  for (size_t s = 0; s < sides.size(); ++s)
    if (mesh.centres[s].instance == 0) floor += double(mesh.areas[s] * open[s]);
  EXPECT_NEAR(floor, 4 - 24 * 24 * 1e-4, 0.005);
}

TEST(CoarseInterpolation, ConstantsAndLinearFieldsAreKept) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {0, 0, 2}, {2, 0, 0}, Rgb(0.5f));
  const PatchMesh mesh = mesh_of(scene, 0.05, 4);
  const Sides sides(mesh);
  const std::vector<float> open(sides.size(), 1);
  const Visibility visibility(scene);
  const CoarsePatches patches(sides, 0.2, open, visibility);
  const CoarseInterpolation interpolation(patches, sides, visibility);
  std::vector<double> values;
  for (size_t i = 0; i < patches.size(); ++i) {
    const Point3 c = patches.centre(i);
    values.insert(values.end(), {7, double(3 + c.x), double(5 + 2 * c.x - c.z)});
  }
  std::vector<Rgb> fine(sides.size(), Rgb(0));
  interpolation.add(values, open, fine);
  for (size_t s = 0; s < sides.size(); ++s) {
    const Point3 c = sides.centre(s);
    const bool border = c.x < 0.2f || c.x > 1.8f || c.z < 0.2f || c.z > 1.8f;
    EXPECT_NEAR(fine[s].r, 7, 1e-4);
    EXPECT_NEAR(fine[s].g, 3 + c.x, border ? 0.08 : 1e-3);
    EXPECT_NEAR(fine[s].b, 5 + 2 * c.x - c.z, border ? 0.16 : 2e-3);
  }
}

}  // namespace
}  // namespace aktina
