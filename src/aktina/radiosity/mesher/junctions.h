// T-junctions: vertices that lie on somebody else's edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aktina/base/vec.h"

namespace aktina {

/// Of the scene's diagonal: what is nearer to an edge lies on it.
inline constexpr float kJunctionTolerance = 1e-6f;

/// Points in a tree of halves (J. L. Bentley, "Multidimensional Binary Search Trees Used for Associative Searching",
/// CACM 18(9), 1975), so that crowds of tiny things in a large scene cost no more than things of one size.
class Junctions {
 public:
  /// @param points  all vertices of the scene
  explicit Junctions(std::span<const Point3> points);

  /// The points within the edge from a to b, its ends excluded, in order from a to b.
  void on_edge(Point3 a, Point3 b, std::vector<Point3>& found) const;

 private:
  struct Edge;
  void build(size_t begin, size_t end);
  void search(size_t begin, size_t end, const Edge& edge, double from, double to) const;

  std::vector<Point3> points_;  // each place once; the one in the middle of a range divides it
  std::vector<uint8_t> axes_;   // along which
  float tolerance_ = 0;
};

}  // namespace aktina
