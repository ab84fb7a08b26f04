// What the models of facets share: how many face which way, how they hide each other, how much they mirror.
#pragma once

#include "aktina/base/vec.h"
#include "aktina/illumination/surface.h"

namespace aktina {

/// Angle between two unit vectors, rad; keeps its digits near 0 and pi.
float angle_between(Vec3 a, Vec3 b);

/// Facet distributions of Blinn 1977, each 1 for facets along the normal. @param alpha  rad, facet off the normal
float facet_phong(float alpha, float c1);             // cos^c1 alpha
float facet_gaussian(float alpha, float c2);          // exp(-(c2 alpha)^2)
float facet_trowbridge_reitz(float alpha, float c3);  // [c3^2 / (cos^2 alpha (c3^2 - 1) + 1)]^2
/// Beckmann's distribution with slope m, exp(-tan^2 alpha / m^2) / (m^2 cos^4 alpha), as Cook and Torrance print it:
/// its integral over the projected facets is pi.
float facet_beckmann(float alpha, float m);

/// Widths that bring a distribution to half its peak at `beta` (rad, in (0, pi / 2)). Blinn 1977, p. 196.
struct FacetWidths {
  float c1, c2, c3;
};
FacetWidths facet_widths(float beta);

/// Share of facets neither in shadow nor hidden, in V-shaped grooves:
/// min(1, 2 (n.h)(n.v) / v.h, 2 (n.h)(n.l) / v.h). Torrance, Sparrow 1967; Blinn 1977, eq. 10.
float groove_masking(Vec3 n, Vec3 wi, Vec3 wo);
/// The same over n.wo, which stays finite where the viewer grazes the surface.
float groove_masking_over_view(Vec3 n, Vec3 wi, Vec3 wo);

/// Fresnel reflectance of a dielectric for unpolarised light. 1 where all is reflected.
/// @param cosine  of incidence, in [0, 1]; @param eta  index beyond the surface over the index before it
float fresnel_dielectric(float cosine, float eta);

/// Slope of the facets of a material: glTF's roughness squared, at least 0.001.
float facet_slope(const Surface& s);

}  // namespace aktina
