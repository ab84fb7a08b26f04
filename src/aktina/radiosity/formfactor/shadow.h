// What occluders leave of a face, seen from a point: exact, by cutting polygons with the planes of sight.
#pragma once

#include "aktina/radiosity/formfactor/face.h"

namespace aktina {

/// Form factors from one point to the parts of a face.
struct VisiblePart {
  double visible = 0, hidden = 0;
};

/// The convex pieces of an occluder that can stand between points above `receiver` and `source`: those in front of
/// both planes.
std::vector<Contour> between(const Face& occluder, const Plane& receiver, const Plane& source, double margin);

/// @param x  receiving point with unit normal n, in front of the plane of `face`
VisiblePart visible_part(Point3d x, Vec3d n, const Face& face, std::span<const Face* const> occluders);

/// The same for pieces prepared for many points of one receiving plane: convex parts of the face above the horizon,
/// and what `between` gives.
VisiblePart visible_part(Point3d x, Vec3d n, std::span<const Contour> pieces, std::span<const Contour> occluders,
                         double margin);

}  // namespace aktina
