// T-junctions: vertices that lie on somebody else's edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aktina/base/vec.h"

namespace aktina {

/// Of the scene's diagonal: what is nearer to an edge lies on it.
inline constexpr float kJunctionTolerance = 1e-6f;

class Junctions {
 public:
  /// @param points  all vertices of the scene
  explicit Junctions(std::span<const Point3> points);

  /// The points within the edge from a to b, its ends excluded, in order from a to b.
  void on_edge(Point3 a, Point3 b, std::vector<Point3>& found) const;

 private:
  using Cell = glm::ivec3;
  Cell cell_of(Point3 p) const;
  size_t index(Cell c) const { return (size_t(c.z) * size_t(count_.y) + size_t(c.y)) * size_t(count_.x) + size_t(c.x); }
  void search(Point3 a, Point3 b, float from, float to, std::vector<uint32_t>& found) const;

  std::vector<Point3> points_;   // each place once, sorted by cell
  std::vector<uint32_t> first_;  // of each cell
  Bounds bounds_;
  Cell count_{1};
  Vec3 per_metre_{0};  // cells
  float tolerance_ = 0;
};

}  // namespace aktina
