#include "aktina/radiosity/solver/hierarchy/cluster_tree.h"

#include <algorithm>
#include <cmath>

namespace aktina {

ClusterTree::ClusterTree(const SurfaceTree& tree) : tree_(tree) {
  for (uint32_t root = 0; root < tree.roots().size(); ++root)
    if (tree.nodes()[root].covered > 0) roots_.push_back(root);
  if (roots_.size() < 2) return;
  clusters_.reserve(roots_.size() - 1);
  build(0, uint32_t(roots_.size()));
  double sum = 0;
  for (const uint32_t root : roots_) sums_.push_back(sum += tree.roots()[root].area);
}

uint32_t ClusterTree::build(uint32_t first, uint32_t count) {
  if (count == 1) return roots_[first];
  const auto begin = roots_.begin() + first, end = begin + count;
  const auto at = uint32_t(clusters_.size());
  Cluster& cluster = clusters_.emplace_back(Cluster{{}, 0, 0, {}, first, count, {}});
  Bounds box, middles;
  for (auto root = begin; root != end; ++root) {
    const TreePatch& patch = tree_.roots()[*root];
    for (const Point3 p : patch.corners()) box.add(p);
    middles.add(patch.middle());
    cluster.area += patch.area;
    for (size_t axis = 0; axis < kAxes; ++axis)
      cluster.across[axis] += patch.area * double(std::max(0.0f, along_axis(patch.normal, axis)));
  }
  cluster.centre = box.centre();
  float squared = 0;
  for (auto root = begin; root != end; ++root)
    for (const Point3 p : tree_.roots()[*root].corners())
      squared = std::max(squared, squared_length(p - cluster.centre));
  cluster.radius = std::sqrt(squared);
  const Vec3 size = middles.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::nth_element(begin, begin + count / 2, end, [&](uint32_t a, uint32_t b) {
    const float p = tree_.roots()[a].middle()[axis], q = tree_.roots()[b].middle()[axis];
    return p != q ? p < q : a < b;
  });
  const uint32_t low = build(first, count / 2), high = build(first + count / 2, count - count / 2);
  clusters_[at].children[0] = low, clusters_[at].children[1] = high;
  return place(at);
}

double ClusterTree::across(uint32_t place, Vec3 direction) const {
  if (!is_cluster(place)) return tree_.area(place) * double(std::max(0.0f, dot(tree_.root(place).normal, direction)));
  double sum = 0;
  for (const uint32_t root : roots(cluster(place))) {
    const TreePatch& patch = tree_.roots()[root];
    sum += patch.area * double(std::max(0.0f, dot(patch.normal, direction)));
  }
  return sum;
}

uint32_t ClusterTree::root_at(const Cluster& cluster, float u) const {
  const auto begin = sums_.begin() + cluster.first, end = begin + cluster.count;
  const double before = cluster.first > 0 ? sums_[cluster.first - 1] : 0;
  const auto at = std::upper_bound(begin, end, before + double(u) * (*(end - 1) - before));
  return roots_[size_t(std::min(at, end - 1) - sums_.begin())];
}

}  // namespace aktina
