// A point light within a cone: a smooth edge between two angles (as glTF has it), or a hard edge with a power of the
// cosine inside. Cost: a point light's, a dot product and perhaps a power. Weakness: a hard cone aliases.
//
// D. R. Warn, "Lighting Controls for Synthetic Images", SIGGRAPH 1983; KHR_lights_punctual, Khronos Group.
#include <algorithm>
#include <cmath>

#include "aktina/illumination/light/light.h"

namespace aktina {

float spot_falloff(const SpotLight& light, float c) {
  const float outer = std::cos(light.outer_angle), inner = std::cos(light.inner_angle);
  if (c < outer) return 0;
  float factor = light.exponent > 0 ? std::pow(std::max(c, 0.0f), light.exponent) : 1;
  // KHR_lights_punctual: the square of a linear ramp in the cosine between the two cones; a hard edge where they meet.
  if (inner > outer && c < inner) {
    const float t = (c - outer) / (inner - outer);
    factor *= t * t;
  }
  return factor;
}

LightSample sample(const SpotLight& light, Point3 x) {
  const Vec3 d = light.position - x;
  const float distance = length(d);
  if (!(distance > 0)) return {{0, 0, 1}, 0, Irradiance()};
  const Vec3 wi = d * (1 / distance);
  const float factor = spot_falloff(light, -dot(wi, light.direction));
  return {wi, distance, Irradiance(light.intensity.v * (factor * attenuate(light.attenuation, distance)))};
}

std::optional<Flux> flux(const SpotLight& light) {
  // 2 pi times the integral of the fall-off over the cosine, by Simpson's rule: exact for the smooth cone (a square).
  constexpr int kSteps = 512;
  const double outer = std::cos(double(light.outer_angle)), inner = std::cos(double(light.inner_angle));
  const auto integral = [&](double a, double b) {
    double sum = 0;
    for (int i = 0; i <= kSteps; ++i) {
      const double c = a + (b - a) * i / kSteps;
      const double ramp = inner > outer && c < inner ? (c - outer) / (inner - outer) : 1;
      const double power = light.exponent > 0 ? std::pow(std::max(c, 0.0), double(light.exponent)) : 1;
      sum += ramp * ramp * power * (i == 0 || i == kSteps ? 1 : i % 2 ? 4 : 2);
    }
    return sum * (b - a) / (3 * kSteps);
  };
  const double middle = std::max(inner, outer);
  return Flux(light.intensity.v * float(2 * kPi * (integral(outer, middle) + integral(middle, 1))));
}

extern constinit const Method<Light> spot_light = {
    {"spot", "Spot light", "warn1983", "A point light within a cone, smooth or hard with an exponent."},
    [](const ParamSet&) -> Light { return SpotLight{}; }};

}  // namespace aktina
