// Photometric quantities are types: a Radiosity does not assign to a Radiance.
//
// One value per colour channel, linear Rec. 709. A radiometric scene reads the same numbers in watts.
#pragma once

#include "aktina/base/rgb.h"
#include "aktina/base/vec.h"

namespace aktina {

template <class Tag>
struct Quantity {
  Rgb v;

  constexpr Quantity() = default;
  constexpr explicit Quantity(Rgb value) : v(value) {}
  constexpr Quantity& operator+=(Quantity o) { return v += o.v, *this; }
  friend constexpr Quantity operator+(Quantity a, Quantity b) { return Quantity(a.v + b.v); }
  friend constexpr Quantity operator*(Quantity a, Rgb s) { return Quantity(a.v * s); }
  friend constexpr Quantity operator*(Quantity a, float s) { return Quantity(a.v * s); }
  friend constexpr bool operator==(const Quantity&, const Quantity&) = default;
};

using Radiance = Quantity<struct RadianceTag>;      // cd m^-2 (nit)
using Irradiance = Quantity<struct IrradianceTag>;  // lx, arriving
using Radiosity = Quantity<struct RadiosityTag>;    // lm m^-2, leaving (exitance)
using Intensity = Quantity<struct IntensityTag>;    // cd
using Flux = Quantity<struct FluxTag>;              // lm

/// Radiance of a Lambertian surface of radiosity b: L = B / pi.
constexpr Radiance lambertian_radiance(Radiosity b) { return Radiance(b.v * float(kInvPi)); }
/// Radiosity of a Lambertian surface of radiance l: B = pi L.
constexpr Radiosity lambertian_radiosity(Radiance l) { return Radiosity(l.v * float(kPi)); }

}  // namespace aktina
