// Polygons of a file -> triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "aktina/base/vec.h"

namespace aktina {

/// Cuts polygons by clipping ears: concave ones right, convex ones into a fan, quads at the shorter diagonal. Hostile
/// polygons that would take too long, and those that cross themselves, become fans.
class Triangulator {
 public:
  /// @param corners  three or more, counter-clockwise, nearly planar; @return three corners a triangle, size() - 2 of
  /// them
  std::span<const std::array<uint32_t, 3>> triangulate(std::span<const Point3> corners);
  /// Polygons that were cut into fans although no ear was found.
  uint64_t given_up() const { return given_up_; }

 private:
  void project(std::span<const Point3> corners);
  bool convex() const;
  bool is_ear(size_t i);
  bool clip_ears();
  void fan();

  std::vector<Vec2d> points_;   // in the polygon's plane
  std::vector<uint32_t> loop_;  // corners that are left
  std::vector<std::array<uint32_t, 3>> triangles_;
  uint64_t work_ = 0, given_up_ = 0;
};

}  // namespace aktina
