#pragma once

#include "aktina/base/method.h"
#include "aktina/base/vec.h"
#include "aktina/illumination/surface.h"

namespace aktina {

/// Half vector of two unit directions; n where they are opposite.
inline Vec3 half_vector(Vec3 wi, Vec3 wo, Vec3 n) { return normalize_or(wi + wo, n); }

/// (n.h)^exponent, 0 where the light is behind the surface. The viewer may be: interpolated normals turn away.
float blinn_highlight(Vec3 n, Vec3 wi, Vec3 wo, float exponent);

/// Blinn's form of the highlight: ks (n.h)^exponent / (pi n.wi); see Phong for the units. sr^-1
/// An exponent of about four times Phong's gives a lobe of the same width.
struct BlinnPhong {
  Reflectance brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
  float highlight(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const { return blinn_highlight(n, wi, wo, s.exponent); }
};

}  // namespace aktina
