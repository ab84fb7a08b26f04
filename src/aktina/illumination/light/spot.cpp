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
  c = std::max(c, -1.0f);  // a cone of 180 degrees leaves nothing out
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
  // 2 pi times the integral of the fall-off over the cosine c: of c^n, and before the inner cone of
  // ((c - outer) / (inner - outer))^2 c^n. With a power there is no light behind.
  const double n = std::max(0.0, double(light.exponent)), outer = std::cos(double(light.outer_angle)),
               inner = std::cos(double(light.inner_angle)), behind = n > 0 ? 0 : -1;
  const auto power = [&](double from, double to, double exponent) {  // of c^exponent
    return (std::pow(to, exponent + 1) - std::pow(from, exponent + 1)) / (exponent + 1);
  };
  double sum = power(std::max({inner, outer, behind}), 1, n);
  if (inner > outer) {
    const double from = std::max(outer, behind), to = std::max(inner, from), width = inner - outer;
    const double ramp =
        n > 0 ? power(from, to, n + 2) - 2 * outer * power(from, to, n + 1) + outer * outer * power(from, to, n)
              : (std::pow(to - outer, 3) - std::pow(from - outer, 3)) / 3;
    sum += ramp / (width * width);
  }
  return Flux(light.intensity.v * float(2 * kPi * sum));
}

extern constinit const Method<Light> spot_light = {
    {"spot", "Spot light", "warn1983", "A point light within a cone, smooth or hard with an exponent."},
    [](const ParamSet&) -> Light { return SpotLight{}; }};

}  // namespace aktina
