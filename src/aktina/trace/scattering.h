// How a point of a surface scatters light: an even body below a rough interface that reflects, and for clear materials
// refracts. What path tracing samples; the classic models of illumination/ are what Whitted's method evaluates.
#pragma once

#include "aktina/base/rgb.h"
#include "aktina/base/vec.h"
#include "aktina/illumination/surface.h"

namespace aktina {

/// What GGX facets reflect in all from a direction, f0 scale + f90 bias; masked light counted as lost.
/// B. Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013 course (the split of f0 and f90).
struct FacetAlbedo {
  float scale, bias;
};
FacetAlbedo facet_albedo(float alpha, float cosine);  // interpolated in a table; within 2e-3
FacetAlbedo mean_facet_albedo(float alpha);           // times 2 cos, over the hemisphere

/// A direction, drawn.
struct ScatterSample {
  Vec3 wi{0};     // local; z > 0 where reflected
  Rgb weight;     // f |cos| / pdf; black: nothing comes from there
  float pdf = 0;  // sr^-1; 0 where the direction is the only possible one (mirror, clear glass)
};

/// Value of f |cos| for two directions, and the density with which sample() would have drawn the second.
struct ScatterValue {
  Rgb value;      // sr^-1
  float pdf = 0;  // sr^-1
};

/// Directions are in the frame of the shading normal, wo above it. Lobes, after glTF 2.0's metallic-roughness model:
///  - the interface: GGX facets with Schlick's reflectance (dielectric and metal), exact Fresnel where light passes;
///    scaled so that light between facets is not lost (a white metal reflects everything at any roughness);
///  - the body: even, (1 - E(wo)) (1 - E(wi)) / (1 - mean E) of its colour, E what the interface reflects from there:
///    symmetric, and a white dielectric reflects everything.
/// Below roughness 0.03 the interface is smooth: mirrored and refracted directions are exact, and eval() is without it.
/// F. Kulla, A. Conty, "Revisiting Physically Based Shading at Imageworks", SIGGRAPH 2017 course; E. Turquin,
/// "Practical Multiple Scattering Compensation for Microfacet Models", 2019.
class Scattering {
 public:
  explicit Scattering(const Surface& surface);

  /// @param inside  the ray comes from within the material, which matters where light passes
  ScatterValue eval(Vec3 wo, Vec3 wi, bool inside) const;
  /// @param u  chooses body or interface, and the direction; choice  chooses between reflection and refraction
  ScatterSample sample(Vec3 wo, Vec2 u, float choice, bool inside) const;

  /// Nothing but exact directions: lights need not be sampled.
  bool only_smooth() const { return smooth_ && is_black(body_); }
  bool black() const { return !shiny_ && is_black(body_); }
  /// Share of light reflected evenly or by the interface, or let through: for lighting features of pictures.
  Rgb albedo() const { return albedo_; }

 private:
  /// The interface as seen from one direction.
  struct Interface {
    float body_share;  // 1 - E(wo): what reaches the body
    float chance;      // of sampling the interface instead of the body
    Rgb compensation;  // factor for light that is scattered between facets
  };
  Interface interface(float cosine, float index_ratio) const;
  Rgb body_value(Vec3 wi, const Interface& seen) const;  // f |cos|
  Rgb facet_reflectance(float cosine, float index_ratio) const;
  Rgb facet_transmittance(float cosine, float index_ratio) const;
  ScatterValue reflection(Vec3 wo, Vec3 wi, float index_ratio, const Interface& seen) const;
  ScatterValue refraction(Vec3 wo, Vec3 wi, float index_ratio, const Interface& seen) const;
  ScatterSample sample_smooth(Vec3 wo, float choice, float index_ratio, const Interface& seen) const;
  Vec3 sample_facets(Vec3 wo, Vec2 u, float choice, float index_ratio) const;
  float index_ratio(bool inside) const { return inside ? 1 / ior_ : ior_; }
  float dielectric_albedo(FacetAlbedo facets) const;

  Rgb body_;                // of the matt part, its share included
  Rgb f0_, metal_, clear_;  // reflectance of dielectric and metal facets, colour of light that passes
  float f90_ = 0;           // of dielectric facets
  float opaque_ = 1, metallic_ = 0, glass_ = 0;  // shares of the surface: opaque dielectric, metal, clear
  float alpha_ = 1, ior_ = 1.5f;
  float body_scale_ = 1;  // one over 1 - E averaged over the hemisphere; 0 where E is 1
  Rgb albedo_;
  bool shiny_ = false, smooth_ = false;
};

}  // namespace aktina
