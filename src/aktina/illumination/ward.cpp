// Brushed and rough surfaces: a Gaussian highlight with a width of its own along and across the scratches, fitted to
// measurements. Cost: a square root, an exponential and a division a light. Weakness: no Fresnel effect; at grazing
// angles the lobe loses energy or, towards the horizon, reflects more than arrives.
//
// G. J. Ward, "Measuring and Modeling Anisotropic Reflection", SIGGRAPH 1992, eq. 5.
#include "aktina/illumination/ward.h"

#include <algorithm>
#include <cmath>

#include "aktina/illumination/facets.h"
#include "aktina/illumination/model.h"

namespace aktina {

Vec2 Ward::widths(const Surface& s) const {
  return {std::max(along > 0 ? along : facet_slope(s), 1e-3f), std::max(across > 0 ? across : facet_slope(s), 1e-3f)};
}

Reflectance Ward::brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  const float n_wi = dot(n, wi), n_wo = dot(n, wo);
  if (n_wi <= 0 || n_wo <= 0) return {};
  const Vec2 a = widths(s);
  const Vec3 h = wi + wo;  // of any length: the exponent is a ratio
  const Vec3 t = normalize_or(cross(Vec3(0, 1, 0), n), {1, 0, 0}), b = cross(n, t);
  const float x = dot(h, t) / a.x, y = dot(h, b) / a.y, z = std::max(dot(h, n), 1e-6f);
  const float lobe =
      std::exp(-(x * x + y * y) / (z * z)) / (4 * float(kPi) * a.x * a.y * std::sqrt(std::max(n_wi * n_wo, kLeast)));
  return {s.kd * float(kInvPi), s.ks * lobe};
}

namespace {
constexpr Param kParams[] = {
    {"along", "1", "slope of the surface along the scratches; 0: the material's roughness squared", 0, 0, 2},
    {"across", "1", "slope across the scratches; 0: the material's roughness squared", 0, 0, 2}};
}

extern constinit const Method<IlluminationModel> ward_illumination = {
    {"ward", "Ward's anisotropic reflection", "ward1992",
     "Gaussian highlight of brushed surfaces, wider across the scratches; one exponential a light, no Fresnel effect.",
     kParams},
    [](const ParamSet& p) -> IlluminationModel {
      return Ward{float(p["along"]), float(p["across"])};
    }};

}  // namespace aktina
