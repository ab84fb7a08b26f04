#pragma once

#include "aktina/base/method.h"
#include "aktina/base/vec.h"
#include "aktina/illumination/surface.h"

namespace aktina {

/// A and B of the model. @param sigma  rad
struct OrenNayarFactors {
  float a, b;
};
inline OrenNayarFactors oren_nayar_factors(float sigma) {
  const float s2 = sigma * sigma;
  return {1 - 0.5f * s2 / (s2 + 0.33f), 0.45f * s2 / (s2 + 0.09f)};
}

/// The qualitative model: f = kd / pi (A + B max(0, cos(phi_i - phi_o)) sin a tan b), a the larger and b the smaller
/// angle with the normal, A = 1 - 0.5 s^2 / (s^2 + 0.33), B = 0.45 s^2 / (s^2 + 0.09). sr^-1
struct OrenNayar {
  float sigma = 0.5f;  // rad, standard deviation of the slope angle of the facets
  Reflectance brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
};

}  // namespace aktina
