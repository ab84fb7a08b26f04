#include "aktina/radiosity/solver/hierarchy/surface_tree.h"

#include <gtest/gtest.h>

#include "radiosity/solver/hierarchy/surfaces.h"

namespace aktina {
namespace {

/// A parallelogram, a triangle, and a trapezium, which is two triangles.
SurfaceLayout three_faces() {
  SurfaceLayout layout;
  const auto add = [&](std::array<Point3, 4> corners) {
    layout.first_pieces.push_back(uint32_t(layout.pieces.size()));
    layout.faces.push_back({corners, {0, 0, 1}});
    const Vec3d twice = corners[2] != corners[3]
                            ? cross(Vec3d(corners[2] - corners[0]), Vec3d(corners[3] - corners[1]))
                            : cross(Vec3d(corners[1] - corners[0]), Vec3d(corners[2] - corners[0]));
    layout.pieces.push_back({uint32_t(layout.pieces.size()), corners, 0.5 * length(twice)});
  };
  add({Point3(0, 0, 0), Point3(2, 0, 0), Point3(3, 1, 0), Point3(1, 1, 0)});
  add({Point3(0, 0, 1), Point3(1, 0, 1), Point3(0, 2, 1), Point3(0, 2, 1)});
  add({Point3(0, 0, 2), Point3(3, 0, 2), Point3(2, 1, 2), Point3(0, 1, 2)});
  layout.first_pieces.push_back(3);
  return layout;
}

void cut_all(SurfaceTree& tree, int times) {
  for (int k = 0; k < times; ++k)
    for (uint32_t node = 0, end = uint32_t(tree.nodes().size()); node < end; ++node)
      if (tree.is_leaf(node)) tree.cut(node);
}

TEST(SurfaceTree, QuartersAreExact) {
  SurfaceTree tree(three_faces(), 1e-6);
  ASSERT_EQ(tree.roots().size(), 4U);
  cut_all(tree, 3);
  std::vector<double> area(4, 0);
  for (uint32_t node = 0; node < tree.nodes().size(); ++node) {
    const TreePatch patch = tree.patch(node);
    EXPECT_GT(dot(cross(patch.u, patch.v), patch.normal), 0) << "as the root is turned";
    if (tree.is_leaf(node)) {
      area[tree.nodes()[node].root] += patch.area;
      continue;
    }
    for (int c = 0; c < 4; ++c) {
      const TreePatch child = tree.patch(tree.nodes()[node].children + uint32_t(c)), quarter = patch.quarter(c);
      EXPECT_NEAR(child.area, patch.area / 4, 1e-9);
      EXPECT_LT(length(child.middle() - quarter.middle()), 1e-6f);
      EXPECT_LT(length(child.u - quarter.u), 1e-6f);
      for (const Point3 p : child.corners())
        EXPECT_LT(length(p - patch.middle()), patch.radius() * (1 + 1e-5f)) << "within the node";
    }
  }
  EXPECT_NEAR(area[0], 2, 1e-6);
  EXPECT_NEAR(area[1], 1, 1e-6);
  EXPECT_NEAR(area[2] + area[3], 2.5, 1e-6);
}

TEST(SurfaceTree, LeavesShareOutTheAreaOfReceivers) {
  const Surfaces s(lit_room(true), 0.3);  // no halves of halves of the walls
  SurfaceTree tree(s.surfaces.layout(), 1e-9);
  cut_all(tree, 3);
  std::vector<double> areas(s.sides.size(), 0);
  for (uint32_t node = 0; node < tree.nodes().size(); ++node) {
    if (!tree.is_leaf(node)) continue;
    double sum = 0;
    for (const SurfaceTree::Overlap& each : tree.overlaps(node)) areas[each.receiver] += each.area, sum += each.area;
    EXPECT_NEAR(sum, tree.area(node), 1e-5 * tree.area(node));
  }
  for (size_t i = 0; i < areas.size(); ++i) EXPECT_NEAR(areas[i], s.problem.areas[i], 1e-5 * s.problem.areas[i]);
}

TEST(SurfaceTree, SmallNodesAreNotCut) {
  const Surfaces s(lit_room(false), 0.5);
  SurfaceTree tree(s.surfaces.layout(), 1);
  cut_all(tree, 1);
  EXPECT_TRUE(tree.may_be_cut(0)) << "it has been cut";
  const uint32_t child = tree.nodes()[0].children;
  EXPECT_TRUE(tree.may_be_cut(child)) << "1 m^2, receivers have 0.25 m^2";
  const uint32_t small = tree.cut(child);
  EXPECT_FALSE(tree.may_be_cut(tree.cut(small)));
}

}  // namespace
}  // namespace aktina
