#include "aktina/radiosity/formfactor/faces.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "aktina/base/error.h"

namespace aktina {
namespace {

/// Whether surfaces reach to both sides of a face's plane. Faces of one plane ask once: a floor may have a million.
class Parting {
 public:
  explicit Parting(const std::vector<Face>& surfaces) : surfaces_(surfaces) {
    for (const Face& face : surfaces) size_ = std::max(size_, length(face.centre - surfaces[0].centre) + face.radius);
  }
  bool parts(const Face& face) {
    const Vec3d n = face.plane.normal;
    const auto cell = [](double x) { return int64_t(std::llround(x * 1e12)); };
    const double offset = dot(n, face.plane.point - surfaces_[0].centre) / size_;
    const auto [at, fresh] = known_.try_emplace({cell(n.x), cell(n.y), cell(n.z), cell(offset)}, false);
    if (fresh) at->second = find(face);
    return at->second;
  }

 private:
  bool find(const Face& face) const {
    bool front = false, back = false;
    const double margin = rounding(face);
    for (const Face& surface : surfaces_) {
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

  const std::vector<Face>& surfaces_;
  double size_ = 0;
  std::map<std::array<int64_t, 4>, bool> known_;
};

}  // namespace

Faces::Faces(const FormFactorScene& scene) {
  surfaces_.reserve(scene.surfaces.size()), occluders_.reserve(scene.occluders.size());
  for (const Polygon& polygon : scene.surfaces)
    surfaces_.push_back(make_face(polygon, fmt::format("surface {}", surfaces_.size())));
  for (const Polygon& polygon : scene.occluders)
    occluders_.push_back(make_face(polygon, fmt::format("occluder {}", occluders_.size())));
  Parting parting(surfaces_);
  for (const Face& face : surfaces_)
    if (parting.parts(face)) blocking_.push_back(&face);
  for (const Face& face : occluders_) blocking_.push_back(&face);
}

void Faces::let_through(std::span<const uint8_t> flags) {
  for (size_t i = 0; i < surfaces_.size(); ++i) surfaces_[i].hides = !flags[i];
  std::erase_if(blocking_, [](const Face* face) { return !face->hides; });
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
