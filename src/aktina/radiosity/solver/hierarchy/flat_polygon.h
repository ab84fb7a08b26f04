// Convex polygons in the reference coordinates of a node.
#pragma once

#include <cmath>
#include <vector>

#include "aktina/base/vec.h"

namespace aktina {

using FlatPolygon = std::vector<Vec2d>;

/// Keeps the side of a line where a + b x + c y >= 0.
void cut_by_line(FlatPolygon& polygon, double a, double b, double c);
/// Keeps what lies in [0, 1]^2, or in the triangle x, y >= 0, x + y <= 1.
void cut_by_reference(FlatPolygon& polygon, bool triangle);

inline double area_of(const FlatPolygon& p) {
  double twice = 0;
  for (size_t k = 2; k < p.size(); ++k) {
    const Vec2d a = p[k - 1] - p[0], b = p[k] - p[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2;
}

/// Reference coordinates of child `c` of a node -> those of the node.
inline Vec2d in_parent(bool triangle, int c, Vec2d p) {
  if (c == 3 && triangle) return {0.5 - p.x / 2, 0.5 - p.y / 2};
  return {p.x / 2 + (c & 1 ? 0.5 : 0), p.y / 2 + (c & 2 ? 0.5 : 0)};
}
/// The other way.
inline Vec2d in_child(bool triangle, int c, Vec2d p) {
  if (c == 3 && triangle) return {1 - 2 * p.x, 1 - 2 * p.y};
  return {2 * p.x - (c & 1 ? 1 : 0), 2 * p.y - (c & 2 ? 1 : 0)};
}

}  // namespace aktina
