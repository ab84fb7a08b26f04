#pragma once

#include "aktina/base/method.h"
#include "aktina/base/vec.h"
#include "aktina/illumination/surface.h"

namespace aktina {

/// Ideal diffuse reflection: f = kd / pi, the same for every direction. sr^-1
/// J. H. Lambert, Photometria, 1760.
struct Lambert {
  Reflectance brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
  float highlight(const Surface& /*s*/, Vec3 /*n*/, Vec3 /*wi*/, Vec3 /*wo*/) const { return 0; }
};

}  // namespace aktina
