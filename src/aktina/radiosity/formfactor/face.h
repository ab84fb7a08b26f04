// A polygon that has been looked at: its plane, area, extent, and convex pieces. What all form-factor methods work on.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "aktina/radiosity/formfactor/formfactor.h"

namespace aktina {

using Contour = std::vector<Point3d>;  // closed; counter-clockwise seen from the front

/// The oriented plane of points x with dot(normal, x - point) = 0; its front is where that is positive.
struct Plane {
  Point3d point;
  Vec3d normal;  // unit
  double height(Point3d x) const { return dot(normal, x - point); }
};

struct Face {
  Contour vertices;
  Plane plane;
  double area;                  // m^2
  Point3d centre;               // of the bounding sphere
  double radius;                // of the bounding sphere, m
  std::vector<Contour> convex;  // pieces that make up the polygon: itself where it is convex, else triangles
  bool hides = true;            // what lies behind it
};

/// @param where  what the polygon is, for messages
/// @throws Error bad_input (fewer than three vertices, not finite, no area, not planar within 1e-6 of its size)
Face make_face(const Polygon& polygon, const std::string& where);

/// The part of a contour on the front of a plane. Points nearer to it than `margin` count as lying on it; empty where
/// nothing is in front by more than that. Of a concave contour that falls apart the parts stay joined by edges in the
/// plane that are passed in both directions: their contour integrals vanish.
Contour clip(std::span<const Point3d> contour, const Plane& plane, double margin);

/// Distance from a point to the face, m.
double distance(const Face& face, Point3d x);

/// How far apart two numbers of the size of these coordinates must be to count as different, m.
inline double rounding(const Face& face) { return 1e-12 * (face.radius + length(face.centre)); }

}  // namespace aktina
