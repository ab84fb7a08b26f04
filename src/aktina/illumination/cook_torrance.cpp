// Mirror facets with Beckmann's distribution of slopes, as a proper BRDF: the first in graphics with units.
// Cost: half vector, Fresnel's square root, an exponential and two divisions a light. Weakness: as printed, the 4 of
// the change from facets to directions is missing, so that the highlight holds four times its Fresnel share (a ks of
// 1/4 mends it); light between facets is lost at high slopes.
//
// R. L. Cook, K. E. Torrance, "A Reflectance Model for Computer Graphics", SIGGRAPH 1981.
#include "aktina/illumination/cook_torrance.h"

#include "aktina/illumination/model.h"

namespace aktina {

Reflectance CookTorrance::brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  const float n_wi = dot(n, wi);
  if (n_wi <= 0 || dot(n, wo) <= 0) return {};
  const Vec3 h = half_vector(wi, wo, n);
  const float d = facet_beckmann(angle_between(n, h), slope > 0 ? slope : facet_slope(s));
  const float lobe = fresnel_dielectric(dot(wo, h), s.ior) * d * groove_masking_over_view(n, wi, wo);
  return {s.kd * float(kInvPi), s.ks * (lobe * float(kInvPi) / n_wi)};
}

namespace {
constexpr Param kParams[] = {
    {"slope", "1", "of the facets, root mean square; 0: the material's roughness squared", 0, 0, 2}};
}

extern constinit const Method<IlluminationModel> cook_torrance_illumination = {
    {"cook_torrance", "Cook-Torrance reflectance", "cook1981",
     "Beckmann facets with shadowing and Fresnel reflectance, reciprocal; one exponential a light.", kParams},
    [](const ParamSet& p) -> IlluminationModel { return CookTorrance{float(p["slope"])}; }};

}  // namespace aktina
