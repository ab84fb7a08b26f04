// What a linked tree keeps: every two leaves linked once, energy, and the full matrix where no error is allowed.
#include "aktina/radiosity/solver/hierarchy/hierarchy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/radiosity/formfactor/closed_forms.h"
#include "radiosity/solver/hierarchy/surfaces.h"

namespace aktina {
namespace {

uint32_t parent_of(const SurfaceTree& tree, uint32_t node) {
  for (uint32_t k = 0; k < tree.nodes().size(); ++k)
    if (!tree.is_leaf(k) && node >= tree.nodes()[k].children && node < tree.nodes()[k].children + 4) return k;
  return TreeNode::kNone;
}

std::vector<uint32_t> with_ancestors(const SurfaceTree& tree, uint32_t node) {
  std::vector<uint32_t> all;
  for (; node != TreeNode::kNone; node = parent_of(tree, node)) all.push_back(node);
  return all;
}

TEST(LinkedTree, EveryTwoLeavesAreLinkedOnce) {
  const Surfaces s(lit_room(true), 0.5);
  LinkedTree h(s.problem, s.surfaces, {.most = 2e-3}, 0);
  for (const double times : {16.0, 4.0, 1.0}) h.link(times, nullptr), h.exchange();
  const SurfaceTree& tree = h.tree();
  std::vector<std::vector<uint32_t>> senders(tree.nodes().size());
  for (uint32_t node = 0; node < tree.nodes().size(); ++node)
    for (const Link& link : h.links().of(node)) senders[node].push_back(link.sender);
  std::vector<uint32_t> leaves;
  for (uint32_t node = 0; node < tree.nodes().size(); ++node)
    if (tree.is_leaf(node)) leaves.push_back(node);
  EXPECT_GT(leaves.size(), 40U);
  std::vector<std::vector<uint32_t>> ancestors;
  for (const uint32_t leaf : leaves) ancestors.push_back(with_ancestors(tree, leaf));
  for (size_t p = 0; p < leaves.size(); ++p)
    for (size_t q = 0; q < leaves.size(); ++q) {
      int count = 0;
      for (const uint32_t receiver : ancestors[p])
        for (const uint32_t sender : senders[receiver])
          count += std::count(ancestors[q].begin(), ancestors[q].end(), sender);
      const bool apart = turned_away(tree.patch(leaves[p]), tree.patch(leaves[q]));
      EXPECT_LE(count, 1);
      EXPECT_TRUE(apart || count == 1) << leaves[p] << " " << leaves[q];
    }
}

TEST(LinkedTree, PushAndPullKeepEnergy) {
  const Surfaces s(lit_room(true), 0.3);
  LinkedTree h(s.problem, s.surfaces, {.most = 1e-4}, 0);
  h.link(4, nullptr), h.exchange(), h.link(1, nullptr);
  for (int k = 0; k < 3; ++k) {
    h.exchange();
    for (uint32_t node = 0; node < h.tree().nodes().size(); ++node) {
      if (h.tree().is_leaf(node)) continue;
      for (size_t b = 0; b < 3; ++b) {
        double mean = 0;
        for (uint32_t c = 0; c < 4; ++c) mean += h.light().radiosity(h.tree().nodes()[node].children + c)[b] / 4;
        EXPECT_NEAR(h.light().radiosity(node)[b], mean, 1e-12 * (1 + mean));
      }
    }
  }
}

/// Boxes that touch nothing: no ray decides anything, and each leaf pair has one factor.
TEST(LinkedTree, WithoutErrorItIsTheMatrixOfItsLeaves) {
  Scene scene = room({2, 1, 1.5f}, Rgb(0.5f));
  scene.materials[1].emission = lambertian_radiance(Radiosity(Rgb(10)));
  const Surfaces s(std::move(scene), 0.7);
  const RadiosityProblem problem = s.green();
  LinkedTree h(problem, s.surfaces, {.most = 0}, 0);
  h.link(1, nullptr), h.exchange(), h.link(1, nullptr), h.exchange(), h.link(1, nullptr);
  for (int k = 0; k < 80; ++k) h.exchange();
  const SurfaceTree& tree = h.tree();
  std::vector<uint32_t> leaves;
  for (uint32_t node = 0; node < tree.nodes().size(); ++node)
    if (tree.is_leaf(node)) leaves.push_back(node);
  const Basis constants = Basis::polynomials(1);
  const Transport transport(constants, Transport::Spread::range);
  std::vector<double> b(leaves.size(), 0), next(leaves.size());
  for (int sweep = 0; sweep < 80; ++sweep) {
    for (size_t p = 0; p < leaves.size(); ++p) {
      double sum = 0;
      for (size_t q = 0; q < leaves.size(); ++q) {
        if (turned_away(tree.patch(leaves[p]), tree.patch(leaves[q]))) continue;
        sum += double(transport.sample(tree.patch(leaves[p]), tree.patch(leaves[q]), nullptr).factor) * b[q];
      }
      next[p] = (tree.nodes()[leaves[p]].root == 1 ? 10 : 0) + 0.5 * sum;
    }
    b = next;
  }
  for (size_t p = 0; p < leaves.size(); ++p) EXPECT_NEAR(h.light().radiosity(leaves[p])[0], b[p], 1e-9 * b[p]);
}

TEST(LinkedTree, LinksGrowWithLeavesNotWithTheirSquare) {
  const auto shape = [](double size) {  // a corner, where nodes get the smaller the nearer they are
    Scene scene;
    add_quad(scene, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, Rgb(0.5f), Rgb(1));
    add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, Rgb(0.5f), Rgb(1));
    const Surfaces s(std::move(scene), size);
    LinkedTree h(s.problem, s.surfaces, {.oracle = Oracle::factor, .most = 0.05}, 0);
    h.link(1, nullptr);
    return std::pair(double(h.links().size()), double(h.leaves()));
  };
  const auto [few_links, few_leaves] = shape(0.1);
  const auto [many_links, many_leaves] = shape(0.0125);
  EXPECT_GT(many_leaves, 5 * few_leaves);
  const double slope = std::log(many_links / few_links) / std::log(many_leaves / few_leaves);
  EXPECT_NEAR(slope, 1, 0.2);
}

TEST(LinkedTree, SymmetryOfSamplesDoesNotHideASpread) {
  const Basis constants = Basis::polynomials(1);
  const Transport transport(constants, Transport::Spread::range);
  const TreePatch floor{{0, 0, 0}, {0, 0, 3}, {3, 0, 0}, {0, 1, 0}, false, 9};
  const TreePatch ceiling{{0, 2, 0}, {3, 0, 0}, {0, 0, 3}, {0, -1, 0}, false, 9};
  EXPECT_GT(transport.sample(floor, ceiling, nullptr).spread, 0.02f);
}

TEST(Transport, FactorsAreThoseOfClosedForms) {
  const Basis constants = Basis::polynomials(1);
  const Transport transport(constants, Transport::Spread::range);
  const TreePatch floor{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, false, 1};
  const TreePatch above{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, false, 1};
  const TreePatch wall{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, false, 1};
  EXPECT_NEAR(transport.sample(floor, above, nullptr).factor, 0.199824895698, 2e-3);
  EXPECT_NEAR(transport.sample(floor, wall, nullptr).factor, 0.200043776075, 6e-3) << "they touch";
  EXPECT_TRUE(turned_away(floor, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, false, 1}));
  EXPECT_FALSE(turned_away(floor, wall));
}

/// Uniform light in a closed room is uniform everywhere, whatever stands in it: what is taken for dark because no ray
/// passed, and what is buried under the box, must not take light away.
TEST(LinkedTree, RowsSumToOneBehindObstacles) {
  Scene scene = room({2, 2, 2}, Rgb(0), Rgb(1));
  add_box(scene, {0.5f, 0, 0.5f}, {0.5f, 1.2f, 0.5f}, Rgb(0));
  for (Material& material : scene.materials) material.emission = lambertian_radiance(Radiosity(Rgb(1)));
  const Surfaces s(std::move(scene), 0.25);
  LinkedTree h(s.problem, s.surfaces, {.most = 1e-5}, 0);
  h.link(4, nullptr), h.exchange(), h.link(1, nullptr), h.exchange();
  const std::vector<double> irradiances = h.light().receivers();
  double mean = 0, area = 0;
  for (size_t i = 0; i < s.sides.size(); ++i) {
    const Point3 c = s.sides.centre(i);
    const bool inside = c.y < 1.2f && c.x > 0.4f && c.x < 1.1f && c.z > 0.4f && c.z < 1.1f && c.y < 1e-3f;
    if (inside || s.sides.normal(i).y < -0.5f) continue;  // under the box; its bottom
    mean += s.problem.areas[i] * irradiances[3 * i], area += s.problem.areas[i];
  }
  EXPECT_NEAR(mean / area, 1, 0.005);
}

}  // namespace
}  // namespace aktina
