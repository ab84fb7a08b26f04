// Measured luminous intensities of a luminaire over the sphere of directions: IES LM-63, EULUMDAT.
#pragma once

#include <vector>

#include "aktina/base/vec.h"

namespace aktina {

/// Intensities on a grid of directions in the C-gamma system (type C of LM-63): gamma is the angle from the axis (0:
/// straight out of the luminaire), C the angle around it. Directions beyond the last gamma are dark.
struct PhotometricTable {
  std::vector<float> c;        // degrees, ascending from 0 to 360; or {0} alone: the same all around
  std::vector<float> gamma;    // degrees, ascending within [0, 180]
  std::vector<float> candela;  // [c][gamma], not negative
};

/// @throws Error bad_param unless the angles are as above and each direction has its finite intensity
void check(const PhotometricTable& table);

/// Linear between the planes and, in each, in the cosine of gamma: so the flux of the light is the zonal sum that
/// photometric reports state. cd
/// @param c  degrees, [0, 360]; @param gamma  degrees, [0, 180]
float intensity(const PhotometricTable& table, float c, float gamma);
/// The same for a direction, where gamma = 0 is `axis` and gamma = 90 in plane C0 is `c0`. All unit, c0 across the
/// axis.
float intensity(const PhotometricTable& table, Vec3 axis, Vec3 c0, Vec3 direction);

/// Integral of intensity() over the sphere, lm: exact up to rounding.
double flux(const PhotometricTable& table);

/// The direction with the highest intensity.
struct PeakIntensity {
  float candela, c, gamma;  // cd, degrees, degrees
};
PeakIntensity peak(const PhotometricTable& table);

}  // namespace aktina
