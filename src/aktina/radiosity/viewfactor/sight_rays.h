// What shadows that overlap leave of a pair: by rays, until the error is small enough.
#pragma once

#include "aktina/radiosity/formfactor/face_rays.h"
#include "aktina/radiosity/formfactor/occluded.h"

namespace aktina {

class SightRays {
 public:
  /// @param wanted  whether there will be any; nothing is built otherwise, and all shares are unknown
  SightRays(const Faces& faces, bool wanted) : built_(wanted) {
    if (wanted) rays_.build(faces);
  }

  /// The visible share of the unobstructed exchange between convex parts of two surfaces, and its error.
  /// @param wanted  error of the share at which to stop
  Estimate visible_share(std::span<const Point3d> receiver, Vec3d receiver_normal, std::span<const Point3d> source,
                         Vec3d source_normal, double wanted, uint32_t seed) const;

 private:
  bool built_;
  FaceRays rays_;
};

}  // namespace aktina
