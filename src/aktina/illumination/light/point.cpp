// A point that shines equally in all directions: E = I / d^2.
// Cost: one reciprocal square root. Weakness: shadows without penumbra; unbounded illuminance close by.
//
// J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, Computer Graphics: Principles and Practice, 2nd ed., 1990.
#include "aktina/illumination/light/light.h"

namespace aktina {

LightSample sample(const PointLight& light, Point3 x) {
  const Vec3 d = light.position - x;
  const float distance = length(d);
  if (!(distance > 0)) return {{0, 0, 1}, 0, Irradiance()};
  return {d * (1 / distance), distance, Irradiance(light.intensity.v * attenuate(light.attenuation, distance))};
}

std::optional<Flux> flux(const PointLight& light) { return Flux(light.intensity.v * float(4 * kPi)); }

extern constinit const Method<Light> point_light = {
    {"point", "Point light", "foley1990", "Shines equally in all directions, E = I / d^2; hard shadows."},
    [](const ParamSet&) -> Light { return PointLight{}; }};

}  // namespace aktina
