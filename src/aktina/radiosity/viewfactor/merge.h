// Facets of one plane that touch -> convex polygons.
#pragma once

#include "aktina/radiosity/formfactor/face.h"

namespace aktina {

/// Convex polygons are cut where they have more corners.
inline constexpr size_t kMostCorners = 12;

/// A convex polygon and its plane.
struct ConvexPolygon {
  Contour vertices;  // counter-clockwise seen from the front, no three on a line
  Plane plane;
};

/// Each connected group of facets with one plane and orientation whose outline is convex becomes one polygon; of other
/// groups each facet gives its convex pieces.
/// @param tolerance  m, below which points are the same
/// @param groups     of each facet: equal for facets of one plane that touch
std::vector<ConvexPolygon> merge_coplanar(const std::vector<const Face*>& facets, double tolerance,
                                          std::vector<uint32_t>& groups);

}  // namespace aktina
