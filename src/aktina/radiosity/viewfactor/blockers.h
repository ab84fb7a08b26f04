// What can stand between surfaces, in as few convex parts as possible: facets of one plane that touch are merged into
// convex polygons, polygons that close a convex body into that body.
#pragma once

#include <cstdint>
#include <vector>

#include "aktina/radiosity/formfactor/faces.h"

namespace aktina {

/// A convex set that no light passes: a closed body, or a polygon (which hides on both sides).
struct Blocker {
  std::vector<Plane> bounds;   // the set is behind all of them; at most kMostBounds
  std::vector<Contour> faces;  // of a body: fronts outward; of a polygon: itself
  bool closed = false;         // a body
  Point3d centre{0};           // of the bounding sphere
  double radius = 0;

  static constexpr size_t kMostBounds = 32;
};

/// @param shrink  faces are drawn in by this share of their size, so that edges which coincide with those of the
///                surfaces do not decide by rounding what is hidden
std::vector<Blocker> find_blockers(const Faces& faces, double shrink);

/// Finds those near a line. Spheres in a tree.
class BlockerTree {
 public:
  explicit BlockerTree(std::vector<Blocker> blockers);
  const Blocker& operator[](uint32_t k) const { return blockers_[k]; }
  size_t size() const { return blockers_.size(); }

  /// Adds those whose bounding spheres come nearer than `reach` to the line from a to b, in ascending order; stops when
  /// there are more than `most`.
  void find(Point3d a, Point3d b, double reach, size_t most, std::vector<uint32_t>& found) const;

 private:
  struct Node {
    Point3d centre;
    double radius;
    uint32_t first, count;  // of the blockers below it; count 1: a leaf
    uint32_t right;         // the left child follows
  };
  uint32_t build(uint32_t first, uint32_t count);

  std::vector<Blocker> blockers_;
  std::vector<Node> nodes_;
};

}  // namespace aktina
