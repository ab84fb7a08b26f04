// Where a line meets a plane, a triangle, a polygon: pure functions in double precision.
#pragma once

#include <optional>
#include <span>

#include "aktina/base/vec.h"

namespace aktina {

/// The line origin + t direction, t in the open interval (near, far).
struct Line {
  Point3d origin;
  Vec3d direction;  // t is in units of its length
  double near = 0, far = __builtin_inf();
  Point3d at(double t) const { return origin + t * direction; }
  bool contains(double t) const { return t > near && t < far; }
};

/// The nearest point of a surface on a line.
struct SurfaceHit {
  double t;
  Vec3d normal;         // unit, front side: outward (sphere, cylinder, cone), counter-clockwise (triangle, polygon)
  double u = 0, v = 0;  // triangles: weights of vertices b and c
};

/// The infinite plane normal . x = d; both sides count. A line parallel to it misses.
std::optional<SurfaceHit> intersect_plane(const Line& line, Vec3d normal, double d);

/// Both sides count; the edges belong to the triangle. Degenerate triangles are missed.
/// T. Moeller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", Journal of Graphics Tools 2(1), 1997.
std::optional<SurfaceHit> intersect_triangle(const Line& line, Point3d a, Point3d b, Point3d c);

/// Planar polygon of any shape: inside where the crossing number is odd. The plane is Newell's, the normal follows the
/// right-hand rule.
/// K. Shimrat, "Algorithm 112: Position of Point Relative to Polygon", Comm. ACM 5(8), 1962.
std::optional<SurfaceHit> intersect_polygon(const Line& line, std::span<const Point3d> vertices);

}  // namespace aktina
