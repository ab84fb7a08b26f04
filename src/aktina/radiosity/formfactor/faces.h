// A scene's polygons, looked at once: what all form-factor methods start from.
#pragma once

#include <span>
#include <vector>

#include "aktina/radiosity/formfactor/face.h"

namespace aktina {

class Faces {
 public:
  Faces() = default;
  /// @throws Error bad_input, as make_face(); "surface 3", "occluder 0"
  explicit Faces(const FormFactorScene& scene);

  size_t size() const { return surfaces_.size(); }
  const Face& operator[](size_t i) const { return surfaces_[i]; }
  const std::vector<Face>& surfaces() const { return surfaces_; }
  const std::vector<Face>& occluders() const { return occluders_; }
  /// Surfaces of which the flag is set hide nothing.
  void let_through(std::span<const uint8_t> flags);

  /// Surfaces and occluders that may hide one surface from another one: those which have surfaces on both sides of
  /// their plane. The walls of a convex room never do.
  std::vector<const Face*> blockers(size_t i, size_t j) const;
  /// The same for a differential area: x itself lies on no surface.
  std::vector<const Face*> blockers(size_t j) const { return blockers(j, j); }

 private:
  std::vector<Face> surfaces_, occluders_;
  std::vector<const Face*> blocking_;
};

/// @throws Error usage (no such surface)
void check_surface(const Faces& faces, size_t i);
/// @throws Error bad_input (a point or normal that is not finite, a normal of no length); the normal made unit
Vec3d checked_normal(Point3d x, Vec3d n);

}  // namespace aktina
