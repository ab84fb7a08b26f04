// A disc that shines: its light as a vector in closed form, from the factors of a small area that faces the disc and of
// one that stands across it. Exactness and use in pictures as for the rectangle.
// Cost: a square root and two divisions. Weakness: no shadows of its own without rays; small highlights.
//
// J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, 3rd ed., 2010, B-12 and B-13.
#include <cmath>

#include "aktina/illumination/light/light.h"

namespace aktina {

LightSample sample(const DiscLight& light, Point3 x) {
  Vec3d normal = light.direction;
  const Vec3d from = Vec3d(x) - Vec3d(light.position);
  double height = dot(from, normal);
  if (height == 0 || (height < 0 && !light.both_sides)) return {{0, 0, 1}, 0, Irradiance()};
  if (height < 0) normal = -normal, height = -height;
  const Vec3d aside = from - normal * height;
  const double h2 = height * height, r2 = double(light.radius) * double(light.radius), l2 = dot(aside, aside);
  // S = sqrt((h^2 + l^2 + r^2)^2 - 4 r^2 l^2); both factors without the cancellation of the printed forms
  const double beyond = l2 + h2 - r2, s = std::sqrt(beyond * beyond + 4 * r2 * h2);
  if (!(s > 0)) return {{0, 0, 1}, 0, Irradiance()};  // on the rim
  const double facing = beyond > 0 ? 2 * r2 * h2 / (s * (s + beyond)) : 0.5 * (1 - beyond / s);
  const double across = 2 * height * r2 / (s * (s + l2 + h2 + r2));
  const Vec3d factor = normal * -facing - aside * across;
  const double distance = facing > 0 ? height / facing * length(factor) : 0;
  return vector_sample(factor * kPi, light.radiance.v, distance);
}

std::optional<Flux> flux(const DiscLight& light) {
  const double area = kPi * double(light.radius) * double(light.radius);
  return Flux(light.radiance.v * float(kPi * area * (light.both_sides ? 2 : 1)));
}

extern constinit const Method<Light> disc_light = {
    {"disc", "Disc area light", "howell2010",
     "Soft diffuse light in closed form; seen by rays, with soft shadows; highlights as small as a point light's."},
    [](const ParamSet&) -> Light { return DiscLight{}; }};

}  // namespace aktina
