// Which corners of triangles meet in one place.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "aktina/base/vec.h"

namespace aktina {

/// Corners, numbered 3 * triangle + k, by the place they stand in: vertices in exactly the same position are one place,
/// named by its first vertex. Cost: O(vertices + triangles), 8 bytes a vertex and 4 a corner.
class CornersByPlace {
 public:
  CornersByPlace(std::span<const Point3> positions, std::span<const std::array<uint32_t, 3>> triangles);

  size_t places() const { return first_.size() - 1; }  // those that are not the first vertex of theirs have no corners
  uint32_t place(uint32_t vertex) const { return place_[vertex]; }
  /// In the order of their numbers.
  std::span<const uint32_t> at(size_t place) const {
    return std::span(corners_).subspan(first_[place], first_[place + 1] - first_[place]);
  }
  /// A vertex more, where another stands.
  void add_vertex_at(uint32_t vertex) { place_.push_back(place_[vertex]); }

 private:
  std::vector<uint32_t> place_;            // of each vertex
  std::vector<uint32_t> first_, corners_;  // corners of place i: from first_[i] to first_[i + 1]
};

}  // namespace aktina
