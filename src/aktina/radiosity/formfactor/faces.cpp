#include "aktina/radiosity/formfactor/faces.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"

namespace aktina {
namespace {

/// Whether surfaces reach to both sides of a face's plane.
bool parts(const Face& face, const std::vector<Face>& surfaces) {
  bool front = false, back = false;
  const double margin = rounding(face);
  for (const Face& surface : surfaces) {
    const double height = face.plane.height(surface.centre), reach = surface.radius + margin;
    if (height > reach) front = true;
    if (height < -reach) back = true;
    if (std::abs(height) <= reach)
      for (const Point3d& v : surface.vertices) {
        front = front || face.plane.height(v) > margin;
        back = back || face.plane.height(v) < -margin;
      }
    if (front && back) return true;
  }
  return false;
}

}  // namespace

Faces::Faces(const FormFactorScene& scene) {
  surfaces_.reserve(scene.surfaces.size()), occluders_.reserve(scene.occluders.size());
  for (const Polygon& polygon : scene.surfaces)
    surfaces_.push_back(make_face(polygon, fmt::format("surface {}", surfaces_.size())));
  for (const Polygon& polygon : scene.occluders)
    occluders_.push_back(make_face(polygon, fmt::format("occluder {}", occluders_.size())));
  for (const Face& face : surfaces_)
    if (parts(face, surfaces_)) blocking_.push_back(&face);
  for (const Face& face : occluders_) blocking_.push_back(&face);
}

std::vector<const Face*> Faces::blockers(size_t i, size_t j) const {
  std::vector<const Face*> others;
  others.reserve(blocking_.size());
  for (const Face* face : blocking_)
    if (face != &surfaces_[i] && face != &surfaces_[j]) others.push_back(face);
  return others;
}

void check_surface(const Faces& faces, size_t i) {
  if (i >= faces.size())
    throw Error(Code::usage, "row", fmt::format("there is no surface {}", i),
                fmt::format("there are {}", faces.size()));
}

Vec3d checked_normal(Point3d x, Vec3d n) {
  const double norm = length(n);
  if (!std::isfinite(squared_length(x))) throw Error(Code::bad_input, "point", "is not finite");
  if (!std::isfinite(norm) || !(norm > 0)) throw Error(Code::bad_input, "normal", "has no direction");
  return n / norm;
}

}  // namespace aktina
