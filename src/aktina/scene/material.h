// What a surface is made of, in glTF's terms and in the classic ones. docs/materials.md states the mapping.
#pragma once

#include <optional>
#include <string>

#include "aktina/base/quantity.h"
#include "aktina/illumination/surface.h"
#include "aktina/texture/texture.h"

namespace aktina {

/// The classic coefficients, where a file states them (MTL, extras.aktina).
struct ClassicMaterial {
  Rgb ka{0}, kd{0.8f}, ks{0}, kr{0}, kt{0};  // as in Surface
  float exponent = 1;                        // Phong's n; Blinn's is four times as large for the same lobe
  float index = 1;                           // of refraction
};

enum class AlphaMode : uint8_t { opaque, mask, blend };

/// glTF 2.0 metallic-roughness with the extensions Aktina reads.
struct Material {
  std::string name;

  Rgb base_colour{1};  // linear
  float alpha = 1;
  Texture base_texture;
  float metallic = 1, roughness = 1;
  Texture metallic_roughness_texture;  // B: metallic, G: roughness
  Texture normal_texture;
  float normal_scale = 1;
  Texture occlusion_texture;  // R; kept for export, not used: Aktina computes occlusion
  float occlusion_strength = 1;
  Radiance emission{Rgb(0)};  // cd/m^2 on the front side (both sides where double_sided)
  Texture emission_texture;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  bool unlit = false;            // KHR_materials_unlit
  float ior = 1.5f;              // KHR_materials_ior
  float transmission = 0;        // KHR_materials_transmission
  Texture transmission_texture;  // R
  float specular_weight = 1;     // KHR_materials_specular
  Rgb specular_tint{1};
  Texture specular_texture, specular_tint_texture;  // A; RGB

  std::optional<ClassicMaterial> classic;  // stated by the file; else derived (surface_of)
  std::string original;                    // the glTF material as JSON text, kept for export; may be empty

  bool emits() const { return !is_black(emission.v); }
};

/// Coefficients of a material at a point: textures and vertex colour applied, classic and physical forms both filled.
/// @param uv  two sets; @param colour  linear RGBA of the vertices, 1 if none
struct MaterialPoint {
  Surface surface;
  Radiance emission;
  float alpha = 1;
};
struct Scene;
MaterialPoint evaluate(const Scene& scene, const Material& material, const Vec2 uv[2], Vec4 colour);

/// The mapping of docs/materials.md, without textures.
Surface surface_of(const Material& material);
Material material_of(const ClassicMaterial& classic);

/// Reflectance of a surface as if all that it scatters, but for sharp pictures, were scattered evenly: its body and its
/// gloss. What radiosity exchanges, and what even light from all around brings back.
Rgb matt_reflectance(const Surface& surface);
Rgb matt_reflectance(const Material& material);  // without textures

}  // namespace aktina
