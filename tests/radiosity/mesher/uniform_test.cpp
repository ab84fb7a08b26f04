// The uniform mesher: what every mesh that light is computed on must be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/scene/tessellate.h"
#include "radiosity/mesher/mesh_checks.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

PatchMesh uniform(const Scene& scene, double size, Warnings* warnings = nullptr, uint64_t most = 1'000'000,
                  const std::string& method = "uniform") {
  Warnings unused;
  return make_method(meshers(), "mesher", method)
      ->mesh(scene, {.patch_size = size, .most_patches = most}, warnings ? *warnings : unused);
}

void expect_short_edges(const PatchMesh& mesh, double size) {
  for (const auto& p : mesh.patches)
    for (size_t k = 0; k < 4; ++k)
      EXPECT_LE(length(mesh.positions[p[k]] - mesh.positions[p[(k + 1) % 4]]), size * 1.0001);
}

TEST(Uniform, CutsRectanglesIntoGridsOfQuads) {
  const PatchMesh mesh = uniform(room({4, 2.5, 3}, Rgb(0.5f)), 0.5);
  EXPECT_EQ(mesh.size(), 2U * (8 * 6 + 8 * 5 + 6 * 5));
  for (size_t i = 0; i < mesh.size(); ++i) {
    EXPECT_TRUE(mesh.is_quad(i));
    EXPECT_NEAR(mesh.areas[i], 0.25f, 1e-5f);
  }
  EXPECT_NEAR(total_area(mesh), 2 * (12 + 10 + 7.5), 1e-4);
  expect_closed(mesh);
  expect_short_edges(mesh, 0.5);
}

TEST(Uniform, NeighboursOfDifferentShapesAgreeOnTheirCommonEdge) {
  // A tetrahedron and a prism with edges of every length; then the same turned, so that nothing is round.
  Scene scene = room({1.7f, 0.9f, 1.1f}, Rgb(0.5f));
  Mesh& floor = scene.meshes[0];  // two triangles that are no quad: the second stands first
  floor.triangles = {{0, 2, 3}, {0, 1, 2}};
  scene.meshes[1].triangle_face = {0, 1}, scene.meshes[1].face_count = 2;
  for (const double size : {0.07, 0.13, 0.31, 0.8}) {
    for (Instance& i : scene.instances) i.to_world = Mat4(1);
    expect_closed(uniform(scene, size));
    const Mat3 turn(normalize(Vec3(1, 2, 3)), normalize(cross(Vec3(1, 2, 3), Vec3(3, 1, 1))),
                    normalize(cross(Vec3(1, 2, 3), cross(Vec3(1, 2, 3), Vec3(3, 1, 1)))));
    for (Instance& i : scene.instances) i.to_world = Mat4(turn);
    const PatchMesh mesh = uniform(scene, size);
    expect_closed(mesh);
    expect_short_edges(mesh, size);
    EXPECT_NEAR(total_area(mesh), 2 * (1.7 * 0.9 + 1.7 * 1.1 + 0.9 * 1.1), 1e-4);
  }
}

TEST(Uniform, VerticesOnForeignEdgesCutThem) {
  // The ceiling in two pieces: its middle vertices lie on the walls' edges, which belong to other meshes.
  Scene scene = room({2, 1, 1}, Rgb(0.5f));
  scene.instances[1].mesh = -1;
  add_quad(scene, {0, 1, 0}, {0.77f, 0, 0}, {0, 0, 1}, Rgb(0.5f));
  add_quad(scene, {0.77f, 1, 0}, {1.23f, 0, 0}, {0, 0, 1}, Rgb(0.5f));
  for (const double size : {0.3, 5.0}) {
    const PatchMesh mesh = uniform(scene, size);
    expect_closed(mesh);
    EXPECT_NEAR(total_area(mesh), 10, 1e-5);
  }
}

TEST(Uniform, PrimitivesAreTessellatedAndClosed) {
  Scene scene;
  scene.primitives = {Sphere{1}};
  scene.instances.emplace_back().primitive = 0;
  scene.materials.emplace_back();
  const TessellatedScene tessellated(scene);
  const PatchMesh mesh = uniform(*tessellated, 0.2);
  expect_closed(mesh);
  EXPECT_LT(total_area(mesh), 4 * kPi) << "inscribed";
  EXPECT_GT(total_area(mesh), 4 * kPi * 0.99);
  for (size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_GT(dot(mesh.normals[v], normalize(mesh.positions[v])), 0.99);
}

TEST(Uniform, PlacesSayWhereAVertexLies) {
  Scene scene = room({2, 1, 1}, Rgb(0.5f));
  scene.instances[3].to_world[3] = Vec4(0.5f, 1, 2, 1);
  const PatchMesh mesh = uniform(scene, 0.23);
  const auto position = [&](const SurfacePoint& at) {
    const Instance& instance = scene.instances[at.instance];
    const Mesh& m = scene.meshes[size_t(instance.mesh)];
    const auto& t = m.triangles[at.triangle];
    return transform_point(instance.to_world,
                           m.positions[t[0]] * (1 - at.u - at.v) + m.positions[t[1]] * at.u + m.positions[t[2]] * at.v);
  };
  for (size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_LT(length(position(mesh.places[v]) - mesh.positions[v]), 1e-6f);
  for (size_t i = 0; i < mesh.size(); ++i) {
    const auto& p = mesh.patches[i];
    const Point3 centre =
        (mesh.positions[p[0]] + mesh.positions[p[1]] + mesh.positions[p[2]] + mesh.positions[p[3]]) * 0.25f;
    ASSERT_TRUE(mesh.is_quad(i));
    EXPECT_LT(length(position(mesh.centres[i]) - centre), 1e-6f);
  }
}

TEST(Uniform, MirroredInstancesKeepTheirFront) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, Rgb(0.5f));
  scene.instances[0].to_world[0][0] = -1;
  const PatchMesh mesh = uniform(scene, 10);
  ASSERT_EQ(mesh.size(), 1U);
  EXPECT_GT(mesh.patch_normals[0].z, 0.99f);
  EXPECT_GT(mesh.normals[0].z, 0.99f);
}

TEST(Uniform, ShootersHoldAllPatchesOnceAndTheirOutline) {
  for (const char* method : {"uniform", "uniform:shooter=1", "uniform:shooter=3"}) {
    const PatchMesh mesh = uniform(room({4, 2.5, 3}, Rgb(0.5f)), 0.25, nullptr, 100'000, method);
    uint32_t next = 0;
    for (const PatchMesh::Shooter& shooter : mesh.shooters) {
      EXPECT_EQ(shooter.first, next);
      EXPECT_GE(shooter.count, 1U);
      next += shooter.count;
      const auto& c = shooter.corners;
      const double outline =
          length(cross(mesh.positions[c[2]] - mesh.positions[c[0]], mesh.positions[c[3]] - mesh.positions[c[1]])) / 2;
      double members = 0;
      for (uint32_t i = shooter.first; i < next; ++i) members += mesh.areas[i];
      EXPECT_NEAR(outline, members, 1e-5);
    }
    EXPECT_EQ(next, mesh.size());
  }
}

TEST(Uniform, AveragesTexturesInLinearLight) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, Rgb(0.5f));
  TextureImage image;
  Bitmap checker;
  checker.width = checker.height = 4, checker.channels = 4;
  for (int i = 0; i < 16; ++i)
    for (int c = 0; c < 4; ++c) checker.pixels.push_back(c == 3 || (i + i / 4) % 2 ? 255 : 0);
  image.pixels = checker;
  scene.images.push_back(image);
  scene.materials[0].base_texture.image = 0;
  scene.materials[0].base_texture.filter = Filter::nearest;
  for (const double size : {2.0, 0.6}) {
    const PatchMesh mesh = uniform(scene, size);
    for (const Rgb rho : mesh.reflectances) EXPECT_NEAR(rho.g, 0.25f, 1e-5f) << "half of it is black";
  }
}

TEST(Uniform, ThinCoverageIsNoReflectanceThatIsTooHigh) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, Rgb(0.8f));
  scene.materials[0].alpha = 0.02f, scene.materials[0].alpha_mode = AlphaMode::blend;  // rho + tau = 0.996
  Warnings warnings;
  const PatchMesh mesh = uniform(scene, 1, &warnings);
  EXPECT_TRUE(warnings.items().empty());
  EXPECT_NEAR(mesh.reflectances[0].r, 0.016f, 1e-6f);
  EXPECT_NEAR(mesh.transmittances[0].r, 0.98f, 1e-6f);
}

TEST(Uniform, WhatLetsLightThroughReflectsLess) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, Rgb(0.8f));
  scene.materials[0].alpha_mode = AlphaMode::blend, scene.materials[0].alpha = 0.25f;
  const PatchMesh mesh = uniform(scene, 10);
  EXPECT_NEAR(mesh.reflectances[0].r, 0.2f, 1e-6f);
  EXPECT_NEAR(mesh.transmittances[0].r, 0.75f, 1e-6f);
}

TEST(Uniform, WhiteIsMadeToLoseSomeLight) {
  Warnings warnings;
  const PatchMesh mesh = uniform(room({1, 1, 1}, Rgb(1)), 10, &warnings);
  for (const Rgb rho : mesh.reflectances) EXPECT_NEAR(rho.r, 0.99f, 1e-6f);
  ASSERT_EQ(warnings.items().size(), 1U);
  EXPECT_EQ(warnings.items()[0].count, 6U);
}

TEST(Uniform, LeavesOutWhatHasNoAreaAndCountsIt) {
  Scene scene = room({1, 1, 1}, Rgb(0.5f));
  Mesh& mesh = scene.meshes[0];
  mesh.positions.push_back(Point3(NAN, 0, 0)), mesh.normals.push_back({0, 1, 0}), mesh.uv[0].push_back(Vec2(0));
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({0, 1, 4});
  Warnings warnings;
  EXPECT_NEAR(total_area(uniform(scene, 0.4, &warnings)), 6, 1e-5);
  ASSERT_EQ(warnings.items().size(), 1U);
  EXPECT_EQ(warnings.items()[0].count, 2U);
}

TEST(Uniform, RefusesTooManyPatchesAndEmptyScenes) {
  EXPECT_THAT(
      [] {
        uniform(room({1, 1, 1}, Rgb(0.5f)), 1e-6);
      },
      testing::ThrowsMessage<Error>(testing::HasSubstr("patches")));
  EXPECT_THROW(uniform(room({1, 1, 1}, Rgb(0.5f)), 0.1, nullptr, 500), Error);
  EXPECT_THROW(uniform(Scene(), 1), Error);
}

}  // namespace
}  // namespace aktina
