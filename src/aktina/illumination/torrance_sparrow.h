#pragma once

#include "aktina/base/method.h"
#include "aktina/illumination/facets.h"

namespace aktina {

enum class FacetDistribution : uint8_t { phong, gaussian, trowbridge_reitz, beckmann };

/// Blinn's form s = D G F / (n.v), which holds the cosine of the light: radiance is Ip (kd n.wi + ks s). As a BRDF the
/// highlight is ks s / (pi n.wi). sr^-1
struct TorranceSparrow {
  FacetDistribution distribution = FacetDistribution::trowbridge_reitz;
  float half_width = 0;  // rad, where D falls to half; 0: from the material's exponent, cos^n = 1/2
  /// The distribution's own parameter: c1, c2, c3 or m.
  float width(const Surface& s) const;
  Reflectance brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
  float highlight(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
};

}  // namespace aktina
