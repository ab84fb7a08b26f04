// What a surface is at one point, as far as an illumination model asks: plain numbers, no textures, no geometry.
#pragma once

#include "aktina/base/rgb.h"

namespace aktina {

/// Coefficients at a point. The classic models read ka .. index, the physically based ones base .. specular;
/// docs/materials.md states how scene materials fill both. All reflectances are in [0, 1].
struct Surface {
  // classic: coefficients of ambient light, diffuse light, highlights of lights, the mirrored ray (Whitted's ks where
  // his S stands) and the transmitted ray; Phong's exponent
  Rgb ka{1}, kd{0.5f}, ks{0}, kr{0}, kt{0};
  float exponent = 1;
  // physically based: glTF's metallic-roughness, KHR_materials_specular, KHR_materials_ior, KHR_materials_transmission
  Rgb base{0.5f};
  float metallic = 0, roughness = 1;
  float ior = 1.5f;           // index of refraction, inside over outside
  Rgb specular_tint{1};       // KHR_materials_specular: colour at normal incidence
  float specular_weight = 1;  // KHR_materials_specular: strength
  float transmission = 0;     // share of the light that enters and is not scattered back, but passes
};

/// BRDF value without the cosine, sr^-1, apart by lobe: the diffuse part is what a base texture multiplies and what
/// Gouraud interpolates in hybrid shading.
struct Reflectance {
  Rgb diffuse, specular;
  Rgb total() const { return diffuse + specular; }
};

}  // namespace aktina
