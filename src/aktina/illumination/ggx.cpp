// Metallic-roughness materials as glTF defines them: the share F of the light is mirrored by facets whose slopes follow
// the GGX distribution; of the rest, the body of a dielectric scatters its base colour evenly, a metal nothing.
// Cost: two square roots and three divisions a light. Weakness: light that is mirrored from facet to facet is lost, two
// thirds of it at roughness 1; and as the share of the body is 1 - F at the facet, not at the surface, a white
// dielectric seen at grazing angles reflects up to a quarter more than it gets.
//
// Khronos Group, glTF 2.0 Specification, appendix B, 2021; B. Walter, S. R. Marschner, H. Li, K. E. Torrance,
// "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007.
#include "aktina/illumination/ggx.h"

#include <algorithm>
#include <cmath>

#include "aktina/illumination/model.h"

namespace aktina {

float ggx_distribution(float alpha, Vec3 h) {
  if (!(h.z > 0)) return 0;
  // alpha^2 cos^2 + sin^2 with the sine taken from x and y: 1 - cos^2 has no digits left near the normal.
  const float a2 = alpha * alpha, d = h.z * h.z * a2 + h.x * h.x + h.y * h.y;
  return a2 / (float(kPi) * d * d);
}

float ggx_masking(float alpha, float cosine) {
  if (!(cosine > 0)) return 0;
  const float a2 = alpha * alpha;
  return 2 * cosine / (cosine + std::sqrt(a2 + (1 - a2) * cosine * cosine));
}

float ggx_visibility(float alpha, float cos_i, float cos_o) {
  const float a2 = alpha * alpha;
  const float i = cos_o * std::sqrt(a2 + (1 - a2) * cos_i * cos_i),
              o = cos_i * std::sqrt(a2 + (1 - a2) * cos_o * cos_o);
  return 0.5f / std::max(i + o, 1e-20f);
}

Vec3 sample_ggx_normal(float alpha, Vec3 wo, Vec2 u) {
  const Vec3 w = normalize_or({alpha * wo.x, alpha * wo.y, wo.z}, {0, 0, 1});  // where the surface is a hemisphere
  const float phi = float(2 * kPi) * u.x, z = (1 - u.y) * (1 + w.z) - w.z;
  const float r = std::sqrt(std::clamp(1 - z * z, 0.0f, 1.0f));
  const Vec3 h = Vec3(r * std::cos(phi), r * std::sin(phi), z) + w;
  return normalize_or({alpha * h.x, alpha * h.y, std::max(h.z, 0.0f)}, {0, 0, 1});
}

float ggx_reflection_pdf(float alpha, Vec3 wo, Vec3 h) {
  return ggx_masking(alpha, wo.z) * ggx_distribution(alpha, h) / (4 * std::max(wo.z, 1e-20f));
}

Rgb dielectric_reflectance(const Surface& s) {
  const float f0 = (s.ior - 1) * (s.ior - 1) / ((s.ior + 1) * (s.ior + 1));
  return clamped(s.specular_tint * f0, 0, 1) * s.specular_weight;
}

Rgb normal_reflectance(const Surface& s) {
  return clamped(dielectric_reflectance(s) * (1 - s.metallic) + s.base * s.metallic, 0, 1);
}

Reflectance Ggx::brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  const float cos_i = dot(n, wi), cos_o = dot(n, wo);
  if (cos_i <= 0 || cos_o <= 0) return {};
  const Frame frame(n);
  const Vec3 h = normalize_or(wi + wo, n);
  const float alpha = ggx_width(s), c = dot(h, wo);
  const float lobe = ggx_distribution(alpha, frame.to_local(h)) * ggx_visibility(alpha, cos_i, cos_o);
  const Rgb coat = schlick_fresnel(dielectric_reflectance(s), s.specular_weight, c);
  const Rgb metal = schlick_fresnel(s.base, 1, c);
  const Rgb body = s.base * ((1 - s.metallic) * (1 - s.transmission) * (1 - max_channel(coat)) * float(kInvPi));
  return {body, (coat * (1 - s.metallic) + metal * s.metallic) * lobe};
}

extern constinit const Method<IlluminationModel> ggx_illumination = {
    {"ggx", "glTF's metallic-roughness model", "walter2007",
     "A diffuse body below a GGX coat, or a GGX metal: physically based; two square roots a light."},
    [](const ParamSet&) -> IlluminationModel { return Ggx{}; }};

}  // namespace aktina
