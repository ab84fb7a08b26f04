#pragma once

#include "aktina/base/method.h"
#include "aktina/base/vec.h"
#include "aktina/illumination/surface.h"

namespace aktina {

/// Mirror direction of l about n: R = 2 (n.l) n - l; unit if both are.
inline Vec3 reflect_about(Vec3 n, Vec3 l) { return n * (2 * dot(n, l)) - l; }

/// (r.wo)^exponent, 0 where the light is behind the surface. The viewer may be: interpolated normals turn away.
float phong_highlight(Vec3 n, Vec3 wi, Vec3 wo, float exponent);

/// Phong's model. Radiance for irradiance E on a plane facing the light is (E / pi) (kd n.wi + ks (r.wo)^n): the
/// classic light colour is E / pi. As a BRDF the highlight is ks (r.wo)^n / (pi n.wi). sr^-1
struct Phong {
  bool fresnel = false;  // W(theta), the Fresnel reflectance at the angle of incidence, multiplies ks
  Reflectance brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
  float highlight(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
};

}  // namespace aktina
