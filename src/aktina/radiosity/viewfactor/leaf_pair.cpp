#include "aktina/radiosity/viewfactor/leaf_pair.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

constexpr size_t kMostNear = 64;  // beyond, rays are faster

/// Whether a leaf has something in front of a plane.
bool reaches(const Leaf& leaf, const Plane& plane, double tolerance) {
  return std::any_of(leaf.hull.begin(), leaf.hull.end(), [&](Point3d p) { return plane.height(p) > tolerance; });
}

/// Whether both leaves are outside of one bound, or the blocker is behind one of the leaves.
bool apart(const Leaf& a, const Leaf& b, const Blocker& blocker, double tolerance) {
  const auto outside = [&](const Leaf& leaf, const Plane& plane) {
    return std::all_of(leaf.hull.begin(), leaf.hull.end(), [&](Point3d p) { return plane.height(p) >= -tolerance; });
  };
  for (const Plane& plane : blocker.bounds)
    if (outside(a, plane) && outside(b, plane)) return true;
  for (const Plane* plane : {&a.plane, &b.plane}) {
    bool behind = plane->height(blocker.centre) <= blocker.radius;
    for (const Contour& face : blocker.faces)
      for (const Point3d& p : face) behind = behind && plane->height(p) <= tolerance;
    if (behind) return true;
  }
  return false;
}

/// Whether a plane through an edge of one hull and a corner of the other has both on one side and the blocker beyond.
bool parted(const Blocker& blocker, const Leaf& a, const Leaf& b, double tolerance) {
  for (size_t i = 0; i < 4; ++i)
    for (const Point3d& corner : b.hull) {
      Vec3d normal = cross(a.hull[(i + 1) % 4] - a.hull[i], corner - a.hull[i]);
      const double norm = length(normal);
      if (!(norm > 0)) continue;
      const Plane plane{a.hull[i], normal / norm};
      double low = 0, high = 0;
      for (const Leaf* leaf : {&a, &b})
        for (const Point3d& p : leaf->hull)
          low = std::min(low, plane.height(p)), high = std::max(high, plane.height(p));
      if (low < -tolerance && high > tolerance) continue;
      double least = INFINITY, most = -INFINITY;
      for (const Contour& face : blocker.faces)
        for (const Point3d& p : face) least = std::min(least, plane.height(p)), most = std::max(most, plane.height(p));
      if ((low >= -tolerance && most <= tolerance) || (high <= tolerance && least >= -tolerance)) return true;
    }
  return false;
}

bool stops_all(const Blocker& blocker, const Leaf& a, const Leaf& b, double tolerance) {
  return blocks_all(
      4, 4, blocker, tolerance, [&](size_t p, size_t k) { return blocker.bounds[k].height(a.hull[p]); },
      [&](size_t q, size_t k) { return blocker.bounds[k].height(b.hull[q]); });
}

bool may_reach_through(const Blocker& blocker, const Leaf& leaf, double tolerance) {
  const double reach = leaf.radius + blocker.radius;
  if (squared_length(leaf.centre - blocker.centre) > reach * reach) return false;
  bool front = false, back = false;
  for (const Contour& face : blocker.faces)
    for (const Point3d& p : face) {
      const double height = leaf.plane.height(p);
      front = front || height > tolerance, back = back || height < -tolerance;
    }
  return front && back;
}

}  // namespace

void LaneHeights::set(const Leaf& leaf, const Blocker& blocker, double tolerance) {
  const size_t bounds = blocker.bounds.size();
  heights_.resize(4 * bounds * kLeaf);
  outside_.fill(0);
  for (size_t k = 0; k < bounds; ++k) {
    const Plane& plane = blocker.bounds[k];
    double lowest[kLeaf];
    std::fill(std::begin(lowest), std::end(lowest), INFINITY);
    for (size_t c = 0; c < 4; ++c) {
      const auto& [x, y, z] = leaf.corners[c];
      float* heights = &heights_[(4 * k + c) * kLeaf];
      for (size_t lane = 0; lane < kLeaf; ++lane) {
        const double h = (x[lane] - plane.point.x) * plane.normal.x + (y[lane] - plane.point.y) * plane.normal.y +
                         (z[lane] - plane.point.z) * plane.normal.z;
        heights[lane] = float(h), lowest[lane] = std::min(lowest[lane], h);
      }
    }
    for (size_t lane = 0; lane < kLeaf; ++lane) outside_[lane] |= uint32_t(lowest[lane] >= -tolerance) << k;
  }
}

void look_between(const Leaf& a, const Leaf& b, const BlockerTree& blockers, double tolerance, LeafView& view) {
  view.blocked = view.crowded = view.entered = false;
  view.candidates.clear();
  view.facing = reaches(a, b.plane, tolerance) && reaches(b, a.plane, tolerance);
  if (!view.facing) return;
  thread_local std::vector<uint32_t> near;
  near.clear();
  blockers.find(a.centre, b.centre, std::max(a.radius, b.radius), kMostNear, near);
  view.crowded = near.size() > kMostNear;
  if (view.crowded) return;
  for (const uint32_t k : near) {
    const Blocker& blocker = blockers[k];
    if (apart(a, b, blocker, tolerance)) continue;
    view.blocked = stops_all(blocker, a, b, tolerance);
    if (view.blocked) return;
    if (parted(blocker, a, b, tolerance) || parted(blocker, b, a, tolerance)) continue;
    view.candidates.push_back(k);
    view.entered = view.entered || may_reach_through(blocker, a, tolerance) || may_reach_through(blocker, b, tolerance);
  }
}

}  // namespace aktina
