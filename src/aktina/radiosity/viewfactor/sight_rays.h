// What shadows that overlap leave of a pair: by rays, until the error is small enough.
#pragma once

#include <mutex>

#include "aktina/radiosity/formfactor/face_rays.h"
#include "aktina/radiosity/formfactor/occluded.h"

namespace aktina {

class SightRays {
 public:
  explicit SightRays(const Faces& faces) : faces_(faces) {}

  /// The visible share of the unobstructed exchange between convex parts of two surfaces, and its error.
  /// @param wanted  error of the share at which to stop
  Estimate visible_share(std::span<const Point3d> receiver, Vec3d receiver_normal, std::span<const Point3d> source,
                         Vec3d source_normal, double wanted, uint32_t seed) const;

 private:
  const Faces& faces_;
  mutable std::once_flag built_;  // only scenes that need rays pay for the tree
  mutable FaceRays rays_;
};

}  // namespace aktina
