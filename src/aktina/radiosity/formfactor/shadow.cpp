#include "aktina/radiosity/formfactor/shadow.h"

#include <algorithm>
#include <cmath>

#include "aktina/radiosity/formfactor/point_to_polygon.h"

namespace aktina {
namespace {

/// The pyramid of sight through a convex polygon: inside is in front of all planes. Empty where x sees it edge-on.
std::vector<Plane> sight_planes(Point3d x, std::span<const Point3d> polygon) {
  const Vec3d ahead = cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
  double side = 0;  // which side x is on; by the largest corner triangle that a fan has
  Vec3d normal = ahead;
  for (size_t i = 2; i + 1 < polygon.size(); ++i) normal += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  side = dot(normal, x - polygon[0]);
  const double reach = length(x - polygon[0]);
  if (!(std::abs(side) > 1e-12 * reach * length(normal))) return {};
  std::vector<Plane> planes;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d m = cross(polygon[i] - x, polygon[(i + 1) % polygon.size()] - x) * (side > 0 ? -1.0 : 1.0);
    if (const double norm = length(m); norm > 0) planes.push_back({x, m / norm});
  }
  return planes;
}

bool outside_one(const Contour& piece, std::span<const Plane> planes, double margin) {
  return std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) {
    return std::all_of(piece.begin(), piece.end(), [&](Point3d p) { return plane.height(p) <= margin; });
  });
}

/// Cuts what the pyramid covers out of a convex piece: what is left goes to `left`; the covered part comes back.
Contour cut(const Contour& piece, std::span<const Plane> pyramid, double margin, std::vector<Contour>& left) {
  Contour rest = piece;
  const size_t before = left.size();
  for (const Plane& plane : pyramid) {
    if (Contour out = clip(rest, {plane.point, -plane.normal}, margin); !out.empty()) left.push_back(std::move(out));
    rest = clip(rest, plane, margin);
    if (rest.empty()) {  // nothing is covered: no need to cut
      left.resize(before);
      left.push_back(piece);
      return {};
    }
  }
  return rest;
}

}  // namespace

std::vector<Contour> between(const Face& occluder, const Plane& receiver, const Plane& source, double margin) {
  std::vector<Contour> pieces;
  for (const Contour& piece : occluder.convex)
    if (Contour above = clip(piece, receiver, margin); !above.empty())
      if (Contour kept = clip(above, source, margin); !kept.empty()) pieces.push_back(std::move(kept));
  return pieces;
}

VisiblePart visible_part(Point3d x, Vec3d n, std::span<const Contour> pieces, std::span<const Contour> occluders,
                         double margin) {
  std::vector<Contour> visible(pieces.begin(), pieces.end()), left;
  VisiblePart part;
  for (const Contour& occluder : occluders) {
    const std::vector<Plane> pyramid = sight_planes(x, occluder);
    if (pyramid.size() < 3) continue;
    left.clear();
    for (Contour& piece : visible) {
      if (outside_one(piece, pyramid, margin)) {
        left.push_back(std::move(piece));
        continue;
      }
      part.hidden += point_to_contour(x, n, cut(piece, pyramid, margin, left));
    }
    visible.swap(left);
    if (visible.empty()) break;
  }
  for (const Contour& piece : visible) part.visible += point_to_contour(x, n, piece);
  return part;
}

VisiblePart visible_part(Point3d x, Vec3d n, const Face& face, std::span<const Face* const> occluders) {
  const double margin = rounding(face);
  const Plane horizon{x, n};
  std::vector<Contour> pieces, blocking;
  for (const Contour& piece : face.convex)
    if (Contour above = clip(piece, horizon, margin); !above.empty()) pieces.push_back(std::move(above));
  for (const Face* occluder : occluders)
    for (Contour& piece : between(*occluder, horizon, face.plane, margin)) blocking.push_back(std::move(piece));
  return visible_part(x, n, pieces, blocking, margin);
}

}  // namespace aktina
