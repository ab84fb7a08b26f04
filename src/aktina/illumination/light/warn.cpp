// A studio lamp: a point light that falls off as a power of the cosine off its axis, and the photographer's controls: a
// cone, and flaps, here planes across the world's axes beyond which nothing is lit.
// Cost: a point light's, a dot product, a power and six comparisons. Weakness: hard edges of cone and flaps alias; a
// flap cuts where the lit point lies, not where the light passes.
//
// D. R. Warn, "Lighting Controls for Synthetic Images", SIGGRAPH 1983.
#include <algorithm>
#include <cmath>

#include "aktina/illumination/light/light.h"

namespace aktina {
namespace {

bool within(Point3 x, Point3 low, Point3 high) {
  return x.x >= low.x && x.y >= low.y && x.z >= low.z && x.x <= high.x && x.y <= high.y && x.z <= high.z;
}

}  // namespace

LightSample sample(const WarnLight& light, Point3 x) {
  const Vec3 d = light.position - x;
  const float distance = length(d);
  if (!(distance > 0)) return {{0, 0, 1}, 0, Irradiance()};
  const Vec3 wi = d * (1 / distance);
  const float cosine = -dot(wi, light.direction);
  if (!(cosine > 0) || cosine < std::cos(light.cone_angle) || !within(x, light.flap_low, light.flap_high))
    return {wi, distance, Irradiance()};
  const float factor = light.exponent > 0 ? std::pow(cosine, light.exponent) : 1;
  return {wi, distance, Irradiance(light.intensity.v * (factor * attenuate(light.attenuation, distance)))};
}

/// Of the lamp without its flaps: 2 pi times the integral of c^p from the cone's cosine (not below 0) to 1.
std::optional<Flux> flux(const WarnLight& light) {
  const double p = std::max(double(light.exponent), 0.0), edge = std::max(std::cos(double(light.cone_angle)), 0.0);
  return Flux(light.intensity.v * float(2 * kPi * (1 - std::pow(edge, p + 1)) / (p + 1)));
}

extern constinit const Method<Light> warn_light = {
    {"warn", "Warn's lamp with cone and flaps", "warn1983",
     "A point light with a power of the cosine off its axis, a cone, and flaps that keep its light within a box."},
    [](const ParamSet&) -> Light { return WarnLight{}; }};

}  // namespace aktina
