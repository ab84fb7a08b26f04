// Whether triangles in a plane lie upon each other.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "aktina/base/vec.h"

namespace aktina {

using FlatTriangle = std::array<Vec2, 3>;

struct FlatOverlap {
  std::vector<uint8_t> upon;  // by triangle: it lies upon one that comes before it
  uint64_t count = 0;         // of those
  bool known = true;          // false: so many come near each other that it was not worth while to tell
};

/// Triangles that share edges or corners only do not overlap; nor do those whose overlap is thinner than 1e-5 of the
/// whole. Cost: linear for triangles that are not much longer than others; given up beyond about 1000 pairs a triangle.
FlatOverlap flat_overlap(std::span<const FlatTriangle> triangles);

/// Twice the area, positive where counter-clockwise (x to the right, y up).
inline float twice_area(const FlatTriangle& t) {
  const Vec2 a = t[1] - t[0], b = t[2] - t[0];
  return a.x * b.y - a.y * b.x;
}

}  // namespace aktina
