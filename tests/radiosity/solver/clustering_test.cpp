#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/radiosity/solver/hierarchy/cluster_tree.h"
#include "aktina/radiosity/solver/hierarchy/hierarchy.h"
#include "radiosity/solver/hierarchy/surfaces.h"

namespace aktina {
namespace {

/// n x n small boxes on the floor of the lit room.
Scene cluttered_room(int n) {
  Scene scene = lit_room(false);
  const float pitch = 1.2f / float(n);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
      add_box(scene, {0.4f + pitch * float(i), 0, 0.4f + pitch * float(k)}, Vec3(pitch / 2), Rgb(0.7f));
  return scene;
}

RadiosityState solve(const Surfaces& s, std::string_view method, double target) {
  return make_method(solvers(), "radiosity", method)
      ->solve(s.problem, s.factors, {.tolerance = 1e-5, .target_error = target});
}

TEST(ClusterTree, HoldsEachSurfaceOnceWithinItsSpheres) {
  const Surfaces s(cluttered_room(3), 10);
  const SurfaceTree surfaces(s.surfaces.layout(), 1);
  const ClusterTree tree(surfaces);
  ASSERT_EQ(tree.clusters().size() + 1, surfaces.roots().size());
  EXPECT_EQ(tree.clusters()[0].count, surfaces.roots().size());
  std::vector<int> parents(surfaces.roots().size(), 0);
  for (const Cluster& c : tree.clusters()) {
    double area = 0;
    for (const uint32_t root : tree.roots(c)) {
      area += surfaces.roots()[root].area;
      for (const Point3 p : surfaces.roots()[root].corners()) EXPECT_LE(length(p - c.centre), c.radius * 1.0001f);
    }
    EXPECT_NEAR(area, c.area, 1e-9);
    for (const uint32_t child : c.children)
      if (!ClusterTree::is_cluster(child)) ++parents[child];
  }
  EXPECT_EQ(parents, std::vector<int>(parents.size(), 1));
}

TEST(ClusterTree, ProjectedAreaIsTheSumOfThoseOfTheSurfaces) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {1, 2, 3}, Rgb(0.5f));
  const Surfaces s(std::move(scene), 10);
  const SurfaceTree surfaces(s.surfaces.layout(), 1);
  const ClusterTree tree(surfaces);
  const Vec3 d = normalize(Vec3(1, -2, 0.5f));
  EXPECT_NEAR(tree.across(ClusterTree::place(0), d), double(6 * d.x - 3 * d.y + 2 * d.z), 1e-5);
  const double faces[kAxes] = {6, 6, 3, 3, 2, 2};
  for (size_t axis = 0; axis < kAxes; ++axis) EXPECT_NEAR(tree.clusters()[0].across[axis], faces[axis], 1e-5);
}

TEST(Clustering, StartsFromOneLinkAndMakesFewerThanOneForEveryTwoSurfaces) {
  std::vector<double> links, faces;
  for (const int n : {6, 12, 24}) {
    const Surfaces s(cluttered_room(n), 10);
    HierarchyOptions options;
    options.clusters = true, options.most = 1e-3;
    LinkedTree tree(s.problem, s.surfaces, options, 0);
    EXPECT_EQ(tree.cluster_links(), 1U);
    EXPECT_EQ(tree.links().size(), 0U);
    tree.link(1, nullptr);
    tree.exchange();
    tree.link(1, nullptr);
    links.push_back(double(tree.cluster_links() + tree.links().size())), faces.push_back(double(s.problem.size()));
  }
  for (size_t k = 1; k < links.size(); ++k)
    EXPECT_LT(std::log(links[k] / links[k - 1]) / std::log(faces[k] / faces[k - 1]), 1.3);
  EXPECT_LT(links.back(), 0.05 * faces.back() * faces.back());
}

TEST(Clustering, ConvergesToTheLightThatLinksBetweenAllSurfacesGive) {
  const Surfaces s(cluttered_room(4), 0.15);
  const std::vector<double> all = solve(s, "hierarchical", 0.003).irradiances;
  double last = 1;
  for (const double target : {0.1, 0.03, 0.01}) {
    const RadiosityState state = solve(s, "clustering", target);
    EXPECT_TRUE(state.converged);
    const double error = difference(s.problem, state.irradiances, all);
    EXPECT_LT(error, 0.8 * last) << target;
    last = error;
  }
  EXPECT_LT(last, 0.03);
}

TEST(Clustering, AsHierarchicalWhereEverySurfaceMatters) {
  const Surfaces s(lit_room(true), 0.15);
  EXPECT_LT(difference(s.problem, solve(s, "clustering", 0.01).irradiances, solve(s, "hierarchical", 0.01).irradiances),
            0.03);
}

TEST(Clustering, LightOfAGlowingRoomIsTheSameEverywhere) {
  Scene scene = room({2, 2, 2}, Rgb(0.5f), Rgb(10));
  for (int i = 0; i < 8; ++i)
    add_box(scene, {0.3f + 0.6f * float(i & 1), 0.3f + 0.6f * float(i >> 1 & 1), 0.3f + 0.6f * float(i >> 2)},
            Vec3(0.2f), Rgb(0.5f), Rgb(10));
  const Surfaces s(std::move(scene), 0.25);
  const double expected = 10 / (1 - 0.5);
  const std::vector<double> irradiances = solve(s, "clustering", 0.01).irradiances;
  const std::vector<double> even(irradiances.size(), expected);
  EXPECT_LT(difference(s.problem, irradiances, even), 0.05);
}

TEST(Clustering, SameBytesForAnyNumberOfThreads) {
  const Surfaces s(cluttered_room(5), 0.3);
  set_thread_count(1);
  const RadiosityState one = solve(s, "clustering", 0.03);
  set_thread_count(2);
  const RadiosityState two = solve(s, "clustering", 0.03);
  set_thread_count(0);
  EXPECT_EQ(one.irradiances, two.irradiances);
}

}  // namespace
}  // namespace aktina
