// A highlight of mirror facets that shadow and hide each other: it grows and leaves the mirror direction where light
// grazes the surface. Cost: half vector, Fresnel's square root and one distribution a light.
// Weakness: not normalised (D is 1 along the normal), so energy is not conserved; grooves are V-shaped.
//
// K. E. Torrance, E. M. Sparrow, "Theory for Off-Specular Reflection from Roughened Surfaces", J. Opt. Soc. Am. 57(9),
// 1967, in the form of J. F. Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977.
#include "aktina/illumination/torrance_sparrow.h"

#include <algorithm>
#include <cmath>

#include "aktina/illumination/model.h"

namespace aktina {
namespace {

constexpr float kNarrowest = 1e-3f;  // rad

/// Half width of cos^n: acos(2^(-1/n)).
float half_width_of(float exponent) { return std::acos(std::exp2(-1 / std::clamp(exponent, 0.05f, 1e6f))); }

/// Scaled to 1 along the normal.
float facets(FacetDistribution distribution, float alpha, float width) {
  if (distribution == FacetDistribution::phong) return facet_phong(alpha, width);
  if (distribution == FacetDistribution::gaussian) return facet_gaussian(alpha, width);
  if (distribution == FacetDistribution::trowbridge_reitz) return facet_trowbridge_reitz(alpha, width);
  return facet_beckmann(alpha, width) * width * width;
}

}  // namespace

float TorranceSparrow::width(const Surface& s) const {
  const float beta = std::clamp(half_width > 0 ? half_width : half_width_of(s.exponent), kNarrowest, 1.5f);
  if (distribution == FacetDistribution::beckmann)
    // exp(-t^2 / m^2) / cos^4 is 1/2 at beta: m^2 = t^2 / (ln 2 - 4 ln cos beta)
    return std::tan(beta) / std::sqrt(std::log(2.0f) - 4 * std::log(std::cos(beta)));
  const FacetWidths width = facet_widths(beta);
  if (distribution == FacetDistribution::phong) return width.c1;
  return distribution == FacetDistribution::gaussian ? width.c2 : width.c3;
}

float TorranceSparrow::highlight(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  if (dot(n, wi) <= 0 || dot(n, wo) <= 0) return 0;
  const Vec3 h = half_vector(wi, wo, n);
  return facets(distribution, angle_between(n, h), width(s)) * groove_masking_over_view(n, wi, wo) *
         fresnel_dielectric(dot(wo, h), s.ior);
}

Reflectance TorranceSparrow::brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  const float n_wi = dot(n, wi);
  if (n_wi <= 0 || dot(n, wo) <= 0) return {};
  return {s.kd * float(kInvPi), s.ks * (highlight(s, n, wi, wo) * float(kInvPi) / n_wi)};
}

namespace {
constexpr Param kParams[] = {
    {"distribution", "1", "0: Phong's cosine, 1: Gaussian, 2: Trowbridge and Reitz, 3: Beckmann", 2, 0, 3, true},
    {"half_width", "rad", "angle at which the distribution falls to half; 0: from the material's exponent", 0, 0, 1.5}};
}

extern constinit const Method<IlluminationModel> torrance_sparrow_illumination = {
    {"torrance_sparrow", "Torrance-Sparrow facets in Blinn's form", "blinn1977",
     "Mirror facets with shadowing and Fresnel reflectance; off-specular peaks at grazing light; not normalised.",
     kParams},
    [](const ParamSet& p) -> IlluminationModel {
      return TorranceSparrow{FacetDistribution(int(p["distribution"])), float(p["half_width"])};
    }};

}  // namespace aktina
