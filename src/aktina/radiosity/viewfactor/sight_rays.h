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

  /// A convex part of a surface.
  struct Part {
    std::span<const Point3d> corners;
    Vec3d normal;
  };
  /// The visible share of the unobstructed exchange between two parts, and its error.
  /// @param exchange  the unobstructed exchange, m^2: a small part that sees much of a large one sends rays by the
  ///                  cosine, for places evenly over the large one are mostly far away
  /// @param wanted    error of the share at which to stop
  Estimate visible_share(const Part& receiver, const Part& source, double exchange, double wanted, uint32_t seed) const;

 private:
  bool built_;
  FaceRays rays_;
};

}  // namespace aktina
