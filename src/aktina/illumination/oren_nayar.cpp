// Rough matt surfaces, like plaster, clay or the moon: Lambertian facets that shadow each other, so that the surface
// looks flatter and returns light towards where it came from.
// Cost: two square roots and a division a light. Weakness: interreflection between facets is left out, so a white
// surface at sigma 0.5 loses up to 22 % of the light (along the normal).
//
// M. Oren, S. K. Nayar, "Generalization of Lambert's Reflectance Model", SIGGRAPH 1994, eq. 30.
#include "aktina/illumination/oren_nayar.h"

#include <algorithm>
#include <cmath>

#include "aktina/illumination/model.h"

namespace aktina {

Reflectance OrenNayar::brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  const float cos_i = dot(n, wi), cos_o = dot(n, wo);
  if (cos_i <= 0 || cos_o <= 0) return {};
  const OrenNayarFactors f = oren_nayar_factors(sigma);
  // cos(phi) sin_i sin_o is the dot product of the parts along the surface; sin a tan b = sin_i sin_o / max(cos)
  const float along = dot(wi, wo) - cos_i * cos_o;
  return {s.kd * (float(kInvPi) * (f.a + f.b * std::max(along, 0.0f) / std::max(cos_i, cos_o))), Rgb()};
}

namespace {
constexpr Param kParams[] = {{"sigma", "rad", "standard deviation of the facets' angles", 0.5, 0, 1.5707}};
}

extern constinit const Method<IlluminationModel> oren_nayar_illumination = {
    {"oren_nayar", "Oren-Nayar rough diffuse reflection", "oren1994",
     "Lambertian facets that shadow each other: rough matt surfaces look flat; no highlight.", kParams},
    [](const ParamSet& p) -> IlluminationModel { return OrenNayar{float(p["sigma"])}; }};

}  // namespace aktina
