#pragma once

#include "aktina/base/method.h"
#include "aktina/base/vec.h"
#include "aktina/illumination/surface.h"

namespace aktina {

// The microfacet functions below take directions in the frame of the surface: z is the cosine with the normal.

/// Density of facet normals per projected area and steradian, D. sr^-1
/// B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, eq. 33 (GGX; the same as
/// Trowbridge-Reitz). @param alpha  width, roughness^2 in glTF
float ggx_distribution(float alpha, Vec3 h);
/// Share of facets not hidden from w, G1, in [0, 1]. Smith's function, ibid. eq. 34.
float ggx_masking(float alpha, float cosine);
/// G2 / (4 cos_i cos_o) with masking and shadowing correlated by height.
/// E. Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), 2014, eq. 99.
float ggx_visibility(float alpha, float cos_i, float cos_o);
/// A facet normal that wo sees, with density G1(wo) D(h) (wo.h)+ / wo.z.
/// J. Dupuy, A. Benyoub, "Sampling Visible GGX Normals with Spherical Caps", HPG 2023.
Vec3 sample_ggx_normal(float alpha, Vec3 wo, Vec2 u);
/// Density of the mirror direction of wo about such a normal: G1(wo) D(h) / (4 wo.z). sr^-1
float ggx_reflection_pdf(float alpha, Vec3 wo, Vec3 h);

/// Schlick's Fresnel reflectance, f0 at normal and f90 at grazing incidence.
/// C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", Eurographics 1994.
inline float schlick_weight(float cosine) {
  const float c = 1 - (cosine < 0 ? 0 : cosine > 1 ? 1 : cosine), c2 = c * c;
  return c2 * c2 * c;
}
inline Rgb schlick_fresnel(Rgb f0, float f90, float cosine) { return f0 + (Rgb(f90) - f0) * schlick_weight(cosine); }

/// Reflectance of a dielectric at normal incidence, with the strength and tint of KHR_materials_specular.
Rgb dielectric_reflectance(const Surface& s);
/// Of any material at normal incidence, f0: that of its dielectric and its metallic share together.
Rgb normal_reflectance(const Surface& s);

/// Width alpha of a material's lobe: its roughness squared, at least 1e-4 (a few arc seconds: below it D overflows).
inline float ggx_width(const Surface& s) {
  const float alpha = s.roughness * s.roughness;
  return alpha > 1e-4f ? alpha : 1e-4f;
}

/// glTF 2.0's metallic-roughness model: a diffuse body below a GGX coat, mixed with a GGX metal. sr^-1
struct Ggx {
  Reflectance brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
};

}  // namespace aktina
