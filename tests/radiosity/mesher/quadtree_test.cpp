// Quadtrees: balance, anchors, and what is kept from mesh to mesh.
#include "aktina/radiosity/mesher/quadtree_forest.h"

#include <gtest/gtest.h>

#include "aktina/base/error.h"
#include "aktina/base/random.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solver/reconstruct.h"
#include "radiosity/mesher/mesh_checks.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

PatchMesh first_mesh(const Scene& scene, double size) {
  Warnings unused;
  return make_method(meshers(), "mesher", "quadtree")->mesh(scene, {.patch_size = size}, unused);
}

Point3 middle_of(const PatchMesh& mesh, size_t patch) {
  Point3 sum(0);
  const size_t n = mesh.is_quad(patch) ? 4 : 3;
  for (size_t k = 0; k < n; ++k) sum += mesh.positions[mesh.patches[patch][k]];
  return sum * (1 / float(n));
}

/// Those within `radius` of a place.
std::vector<uint8_t> marks_near(const PatchMesh& mesh, Point3 place, float radius) {
  std::vector<uint8_t> marks;
  for (size_t i = 0; i < mesh.size(); ++i) marks.push_back(length(middle_of(mesh, i) - place) < radius);
  return marks;
}

/// A room whose floor and one wall are triangles of their own, and a box: edges of several kinds.
Scene mixed_room() {
  Scene scene = room({2, 1.3f, 1.7f}, Rgb(0.5f));
  scene.meshes[0].triangle_face = {0, 1}, scene.meshes[0].face_count = 2;
  scene.meshes[2].triangle_face = {0, 1}, scene.meshes[2].face_count = 2;
  return scene;
}

void expect_consistent(const PatchMesh& mesh) {
  uint32_t next = 0;
  for (const PatchMesh::Shooter& shooter : mesh.shooters) {
    ASSERT_EQ(shooter.first, next);
    next += shooter.count;
    const auto& c = shooter.corners;
    const auto at = [&](size_t k) { return mesh.positions[c[k]]; };
    const double outline = c[2] != c[3] ? length(cross(at(2) - at(0), at(3) - at(1))) / 2
                                        : length(cross(at(1) - at(0), at(2) - at(0))) / 2;
    double members = 0;
    for (uint32_t i = shooter.first; i < next; ++i) members += mesh.areas[i];
    EXPECT_NEAR(outline, members, 1e-5);
  }
  ASSERT_EQ(next, mesh.size());
  for (size_t i = 0; i < mesh.size(); ++i) {
    const auto& c = mesh.patches[i];
    const size_t n = mesh.is_quad(i) ? 4 : 3;
    for (size_t k = 0; k < n; ++k) {  // convex, and counter-clockwise about its normal
      const Point3 a = mesh.positions[c[k]], b = mesh.positions[c[(k + 1) % n]], d = mesh.positions[c[(k + 2) % n]];
      EXPECT_GT(dot(cross(b - a, d - b), mesh.patch_normals[i]), 0.0f);
    }
  }
}

TEST(Quadtree, StaysClosedWhereverItIsRefined) {
  const Scene scene = mixed_room();
  for (const double size : {0.31, 0.8, 5.0}) {
    QuadtreeForest forest(scene, first_mesh(scene, size), 1'000'000);
    const double area = total_area(forest.mesh());
    for (int round = 0; round < 4; ++round) {
      forest.refine(marks_near(forest.mesh(), {0.02f, 0.01f, 0.9f}, 0.4f / float(1 << round)), 8);
      expect_closed(forest.mesh());
      expect_consistent(forest.mesh());
      EXPECT_NEAR(total_area(forest.mesh()), area, 1e-4);
    }
  }
}

TEST(Quadtree, StaysClosedWhereMarksAreRandom) {
  const Scene scene = mixed_room();
  for (uint32_t seed = 0; seed < 20; ++seed) {
    QuadtreeForest forest(scene, first_mesh(scene, 0.7), 1'000'000);
    for (uint32_t round = 0; round < 5; ++round) {
      std::vector<uint8_t> marks(forest.mesh().size());
      for (uint32_t i = 0; i < marks.size(); ++i) marks[i] = hash_combine(hash_combine(seed, round), i) % 16 == 0;
      forest.refine(marks, 8);
      expect_closed(forest.mesh());
    }
    expect_consistent(forest.mesh());
  }
}

TEST(Quadtree, LevelsOfNeighboursDifferByOneAtMost) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {8, 0, 0}, {0, 8, 0}, Rgb(0.5f));
  QuadtreeForest forest(scene, first_mesh(scene, 1), 1'000'000);
  for (int round = 0; round < 5; ++round)
    forest.refine(marks_near(forest.mesh(), {3.1f, 3.1f, 0}, 0.8f / float(1 << round)), 5);
  const PatchMesh& mesh = forest.mesh();
  std::map<std::pair<uint32_t, uint32_t>, std::vector<float>> areas;  // of the patches at each edge
  float smallest = 1;
  for (uint32_t i = 0; i < mesh.size(); ++i) {
    const auto& c = mesh.patches[i];
    const size_t n = mesh.is_quad(i) ? 4 : 3;
    for (size_t k = 0; k < n; ++k) areas[std::minmax(c[k], c[(k + 1) % n])].push_back(mesh.areas[i]);
    smallest = std::min(smallest, mesh.areas[i]);
  }
  EXPECT_FLOAT_EQ(smallest, 1 / 1024.0f);
  // An anchored leaf's patches have a fourth of its area or more but for corners cut off (an eighth), and its
  // neighbours a fourth of the leaf.
  for (const auto& [edge, both] : areas) {
    if (both.size() < 2) continue;  // the border
    EXPECT_LE(std::max(both[0], both[1]), 4.001f * std::min(both[0], both[1]));
  }
}

TEST(Quadtree, NoDeeperThanAllowed) {
  const Scene scene = mixed_room();
  QuadtreeForest forest(scene, first_mesh(scene, 5), 1'000'000);
  for (int round = 0; round < 4; ++round) forest.refine(std::vector<uint8_t>(forest.mesh().size(), 1), 2);
  EXPECT_EQ(forest.mesh().size(), 16 * first_mesh(scene, 5).size());
  EXPECT_TRUE(forest.refine(std::vector<uint8_t>(forest.mesh().size(), 1), 2).empty());
}

TEST(Quadtree, SaysWhichPatchesStayAsTheyWere) {
  const Scene scene = mixed_room();
  QuadtreeForest forest(scene, first_mesh(scene, 0.3), 1'000'000);
  for (int round = 0; round < 3; ++round) {
    const PatchMesh before = forest.mesh();
    const std::vector<uint32_t> origin = forest.refine(marks_near(before, {1, 0, 0.9f}, 0.3f / float(1 << round)), 8);
    const PatchMesh& after = forest.mesh();
    ASSERT_EQ(origin.size(), after.size());
    size_t kept = 0;
    for (size_t i = 0; i < after.size(); ++i) {
      if (origin[i] == QuadtreeForest::kNew) continue;
      ++kept;
      EXPECT_EQ(after.patches[i], before.patches[origin[i]]);
      EXPECT_EQ(after.areas[i], before.areas[origin[i]]);
    }
    EXPECT_GT(kept, before.size() / 2);
    EXPECT_LT(kept, before.size());
    EXPECT_TRUE(std::equal(before.positions.begin(), before.positions.end(), after.positions.begin()));
  }
}

TEST(Quadtree, ConstantsAndLinearFieldsAreExactAcrossAnchors) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {4, 0, 0}, {0, 3, 0}, Rgb(0.5f));
  QuadtreeForest forest(scene, first_mesh(scene, 0.5), 1'000'000);
  for (int round = 0; round < 3; ++round)
    forest.refine(marks_near(forest.mesh(), {1.3f, 1.1f, 0}, 0.6f / float(1 << round)), 8);
  const PatchMesh& mesh = forest.mesh();
  const auto field = [](Point3 p) { return Irradiance(Rgb(7, 2 + p.x, 9 - 1.5f * p.x + 0.7f * p.y)); };
  std::vector<Irradiance> values;
  for (size_t i = 0; i < mesh.size(); ++i) values.push_back(field(middle_of(mesh, i)));
  const std::vector<Irradiance> vertices = Reconstruction(mesh).at_vertices(values);
  for (size_t v = 0; v < vertices.size(); ++v)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(vertices[v].v[c], field(mesh.positions[v]).v[c], 2e-4f);
}

TEST(Quadtree, RefusesTooManyPatches) {
  const Scene scene = mixed_room();
  QuadtreeForest forest(scene, first_mesh(scene, 0.3), 500);
  EXPECT_THROW(forest.refine(std::vector<uint8_t>(forest.mesh().size(), 1), 8), Error);
}

}  // namespace
}  // namespace aktina
