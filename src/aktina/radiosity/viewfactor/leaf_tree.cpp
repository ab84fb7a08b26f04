#include "aktina/radiosity/viewfactor/leaf_tree.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

constexpr size_t kMostBlockers = 16;  // looked at between a leaf and a node: it is only to save time

bool same_plane(const Leaf& a, const Leaf& b) {
  return a.plane.normal == b.plane.normal && a.plane.point == b.plane.point;
}

}  // namespace

LeafTree::LeafTree(std::vector<Leaf>& leaves) : leaves_(leaves) {
  if (leaves.empty()) return;
  // Leaves of one plane follow each other already, near ones near by.
  std::vector<Group> groups;
  for (uint32_t k = 0; k < leaves.size(); ++k) {
    const bool fresh = k == 0 || !same_plane(leaves[k - 1], leaves[k]);
    if (fresh) groups.push_back({k, 0, Point3d(0)});
    Group& group = groups.back();
    ++group.count, group.centre += leaves[k].centre;
  }
  for (Group& group : groups) group.centre /= double(group.count);
  order(groups, 0, groups.size());
  std::vector<Leaf> ordered;
  ordered.reserve(leaves.size());
  for (Group& group : groups) {
    const auto begin = leaves.begin() + std::ptrdiff_t(group.first);
    group.first = uint32_t(ordered.size());
    ordered.insert(ordered.end(), begin, begin + std::ptrdiff_t(group.count));
  }
  leaves.swap(ordered);
  build(groups, 0, groups.size());
}

/// Halves along the longest side.
void LeafTree::order(std::vector<Group>& groups, size_t first, size_t count) {
  if (count <= 1) return;
  Point3d low(INFINITY), high(-INFINITY);
  for (size_t k = first; k < first + count; ++k)
    low = glm::min(low, groups[k].centre), high = glm::max(high, groups[k].centre);
  const Vec3d size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto begin = groups.begin() + std::ptrdiff_t(first);
  std::stable_sort(begin, begin + std::ptrdiff_t(count),
                   [&](const Group& a, const Group& b) { return a.centre[axis] < b.centre[axis]; });
  order(groups, first, count / 2);
  order(groups, first + count / 2, count - count / 2);
}

uint32_t LeafTree::build(const std::vector<Group>& groups, size_t first, size_t count) {
  if (count == 1) return build(groups[first].first, groups[first].count, true);
  uint32_t leaves = 0;
  for (size_t k = first; k < first + count; ++k) leaves += groups[k].count;
  const uint32_t at = build(groups[first].first, leaves, false);
  build(groups, first, count / 2);
  const uint32_t right = build(groups, first + count / 2, count - count / 2);
  nodes_[at].right = right;
  return at;
}

/// @param one_plane  of all of them; then with everything below it, else alone
uint32_t LeafTree::build(uint32_t first, uint32_t count, bool one_plane) {
  const auto at = uint32_t(nodes_.size());
  Point3d low(INFINITY), high(-INFINITY);
  for (uint32_t k = first; k < first + count; ++k)
    for (const Point3d& p : leaves_[k].hull) low = glm::min(low, p), high = glm::max(high, p);
  Node node{{}, 0.5 * (low + high), 0.5 * length(high - low), first, count, 0, one_plane};
  for (size_t k = 0; k < 8; ++k)
    node.corners[k] = {k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z};
  nodes_.push_back(node);
  if (!one_plane || count == 1) return at;
  build(first, count / 2, true);
  const uint32_t right = build(first + count / 2, count - count / 2, true);
  nodes_[at].right = right;
  return at;
}

bool LeafTree::faces(const Node& node, const Leaf& leaf, double tolerance) const {
  const auto reaches = [&](std::span<const Point3d> corners, const Plane& plane) {
    return std::any_of(corners.begin(), corners.end(), [&](Point3d p) { return plane.height(p) > tolerance; });
  };
  return (!node.one_plane || reaches(leaf.hull, leaves_[node.first].plane)) && reaches(node.corners, leaf.plane);
}

bool LeafTree::is_hidden(const Node& node, const Leaf& leaf, const BlockerTree& blockers, double tolerance) const {
  if (node.radius + leaf.radius > length(node.centre - leaf.centre)) return false;
  thread_local std::vector<uint32_t> near;
  near.clear();
  blockers.find(leaf.centre, node.centre, 0, kMostBlockers, near);
  return std::any_of(near.begin(), near.end(), [&](uint32_t k) {
    const Blocker& blocker = blockers[k];
    return blocks_all(
        leaf.hull.size(), node.corners.size(), blocker, tolerance,
        [&](size_t p, size_t bound) { return blocker.bounds[bound].height(leaf.hull[p]); },
        [&](size_t q, size_t bound) { return blocker.bounds[bound].height(node.corners[q]); });
  });
}

void LeafTree::visit(const Leaf& leaf, uint32_t from, const BlockerTree& blockers, double tolerance,
                     FunctionRef<void(uint32_t)> visitor) const {
  if (nodes_.empty()) return;
  uint32_t stack[128], depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const uint32_t at = stack[--depth];
    const Node& node = nodes_[at];
    if (node.first + node.count <= from || !faces(node, leaf, tolerance)) continue;
    if (node.count == 1) {
      visitor(node.first);
      continue;
    }
    if (is_hidden(node, leaf, blockers, tolerance)) continue;
    stack[depth++] = node.right, stack[depth++] = at + 1;
  }
}

}  // namespace aktina
