#pragma once

#include "aktina/base/method.h"
#include "aktina/illumination/facets.h"

namespace aktina {

/// f = kd / pi + ks F D G / (pi (n.wi)(n.wo)) with Beckmann's D. sr^-1
struct CookTorrance {
  float slope = 0;  // m, root mean square slope of the facets; 0: the material's roughness squared
  Reflectance brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
};

}  // namespace aktina
