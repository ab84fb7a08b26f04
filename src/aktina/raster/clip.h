// Clipping of triangles where the camera cannot see, in homogeneous coordinates.
#pragma once

#include <array>

#include "aktina/raster/view.h"

namespace aktina {

/// A corner of a clipped triangle: where it is, and its barycentric coordinates in the triangle it came from.
struct ClipVertex {
  Vec4 clip;  // as View::clip_from_world
  Vec3 barycentric;
};

inline constexpr int kMostClippedVertices = 9;  // three, and one more for each of six planes

class Clipper {
 public:
  explicit Clipper(const View& view);

  /// Bits of the planes that a point is beyond; bits common to three vertices hide their triangle, no bits at all
  /// leave it whole. Points that are not finite are beyond all of them.
  unsigned outside(Vec4 clip) const;
  /// The convex polygon that is left of a triangle: number of vertices, 0 or 3 to 9. Points cut on an edge come out
  /// the same for both triangles of the edge.
  int clip(const std::array<Vec4, 3>& triangle, std::array<ClipVertex, kMostClippedVertices>& out) const;

 private:
  static constexpr int kPlanes = 6;
  float distance(int plane, Vec4 clip) const;
  float near_, far_, guard_x_, guard_y_;
};

}  // namespace aktina
