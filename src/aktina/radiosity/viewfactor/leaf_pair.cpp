#include "aktina/radiosity/viewfactor/leaf_pair.h"

#include <algorithm>

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

}  // namespace

FragmentHeights::FragmentHeights(const Leaves& leaves, const Leaf& leaf, const Blocker& blocker, double tolerance)
    : bounds_(blocker.bounds.size()), heights_(4 * leaf.count * blocker.bounds.size()) {
  for (uint32_t k = 0; k < leaf.count; ++k) {
    const Contour& corners = leaves.fragments[leaf.first + k].face.vertices;
    corners_[k] = uint8_t(corners.size());
    outside_[k] = bounds_ == 32 ? 0xffffffffU : (1U << bounds_) - 1;
    for (size_t c = 0; c < corners.size(); ++c)
      for (size_t b = 0; b < bounds_; ++b) {
        const double h = blocker.bounds[b].height(corners[c]);
        heights_[(4 * k + c) * bounds_ + b] = h;
        if (h < -tolerance) outside_[k] &= ~(1U << b);
      }
  }
}

void look_between(const Leaf& a, const Leaf& b, const BlockerTree& blockers, double tolerance, LeafView& view) {
  view.blocked = view.crowded = false;
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
    if (!parted(blocker, a, b, tolerance) && !parted(blocker, b, a, tolerance)) view.candidates.push_back(k);
  }
}

}  // namespace aktina
