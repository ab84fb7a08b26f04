// Mirrored and transmitted directions at a boundary of two media, and how much of the light goes which way: pure
// functions in double precision.
#pragma once

#include <optional>

#include "aktina/base/vec.h"

namespace aktina {

/// Direction of the mirrored ray, unit. @param incident  unit, towards the surface; n  unit, on either side
Vec3d reflect_direction(Vec3d incident, Vec3d n);

/// Direction of the transmitted ray by Snell's law, unit; none: total internal reflection.
/// @param index_ratio  kn: the index of the medium that is entered over that of the medium that is left
std::optional<Vec3d> refract_direction(Vec3d incident, Vec3d n, double index_ratio);

/// The same in the form of Whitted's paper: P = kf (n + V') - n with V' = V / |V.n| and
/// kf = (kn^2 |V'|^2 - |V' + n|^2)^(-1/2); agrees with Snell's form within rounding.
/// T. Whitted, "An Improved Illumination Model for Shaded Display", Comm. ACM 23(6), 1980.
std::optional<Vec3d> refract_direction_whitted(Vec3d incident, Vec3d n, double index_ratio);

/// Shares of light that a smooth boundary of two dielectrics reflects, [0, 1].
struct FresnelReflectance {
  double s, p;  // polarized across and along the plane of incidence
  double unpolarized() const { return 0.5 * (s + p); }
};
/// @param cosine  of the angle of incidence, [0, 1]; index_ratio  as above. 1 at total internal reflection.
/// M. Born, E. Wolf, Principles of Optics, 1959.
FresnelReflectance fresnel_reflectance(double cosine, double index_ratio);

}  // namespace aktina
