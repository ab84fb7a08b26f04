// A rectangular (or any parallelogram's) lamp: soft light without a sample, by Lambert's contour formula as a vector.
// Diffuse light is exact for surfaces that have the whole lamp above their horizon, and too weak where the horizon cuts
// it; a highlight sees all light come from the vector's direction, so it is as small as a point light's. Rays meet the
// lamp as a surface, with its own shape in mirrors and soft shadows.
// Cost: four square roots and four arc tangents. Weakness: no shadows of its own without rays; small highlights.
//
// J. H. Lambert, Photometria, 1760; D. R. Baum, H. E. Rushmeier, J. M. Winget, "Improving Radiosity Solutions Through
// the Use of Analytically Determined Form-Factors", SIGGRAPH 1989.
#include <cmath>

#include "aktina/illumination/light/light.h"

namespace aktina {

LightSample vector_sample(Vec3d irradiance, Rgb radiance, double distance) {
  const double size = length(irradiance);
  if (!(size > 0) || !std::isfinite(size)) return {{0, 0, 1}, 0, Irradiance()};
  return {Vec3(irradiance / size), float(distance), Irradiance(radiance * float(size))};
}

LightSample sample(const RectangleLight& light, Point3 x) {
  const Vec3d u = light.edge_u, v = light.edge_v, normal = cross(u, v), first = Vec3d(light.corner) - Vec3d(x);
  const double side = -dot(first, normal);  // of x
  if (side == 0 || (side < 0 && !light.both_sides)) return {{0, 0, 1}, 0, Irradiance()};
  // 1/2 sum of theta_k r_{k+1} x r_k / |r_{k+1} x r_k|; the contour runs the other way seen from behind
  const Vec3d corner[4] = {first, first + u, first + u + v, first + v};
  Vec3d sum(0);
  for (int k = 0; k < 4; ++k) {
    const Vec3d across = cross(corner[(k + 1) % 4], corner[k]);
    const double sine = length(across);
    if (sine > 0) sum += across * (std::atan2(sine, dot(corner[(k + 1) % 4], corner[k])) / sine);
  }
  const Vec3d irradiance = sum * (side > 0 ? 0.5 : -0.5);
  const double approach = dot(irradiance, normal);
  const double distance = approach != 0 ? dot(first, normal) / approach * length(irradiance) : 0;
  return vector_sample(irradiance, light.radiance.v, distance);
}

std::optional<Flux> flux(const RectangleLight& light) {
  const double area = length(cross(Vec3d(light.edge_u), Vec3d(light.edge_v)));
  return Flux(light.radiance.v * float(kPi * area * (light.both_sides ? 2 : 1)));
}

extern constinit const Method<Light> rectangle_light = {
    {"rectangle", "Rectangular area light", "baum1989",
     "Soft diffuse light in closed form; seen by rays, with soft shadows; highlights as small as a point light's."},
    [](const ParamSet&) -> Light { return RectangleLight{}; }};

}  // namespace aktina
