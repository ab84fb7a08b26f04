#include "aktina/import/gltf/materials.h"

#include <algorithm>

namespace aktina::gltf {
namespace {

void read_metallic_roughness(Document& document, const Value& pbr, Material& m) {
  float base[] = {1, 1, 1, 1};
  pbr["baseColorFactor"].numbers(base);
  m.base_colour = {base[0], base[1], base[2]}, m.alpha = base[3];
  m.base_texture = read_texture(document, pbr["baseColorTexture"]);
  m.metallic = pbr["metallicFactor"].real(1), m.roughness = pbr["roughnessFactor"].real(1);
  m.metallic_roughness_texture = read_texture(document, pbr["metallicRoughnessTexture"]);
}

AlphaMode alpha_mode(Document& document, const Value& mode) {
  const std::string_view text = mode ? mode.text_view() : "OPAQUE";
  if (text == "MASK") return AlphaMode::mask;
  if (text == "BLEND") return AlphaMode::blend;
  if (text != "OPAQUE") document.warnings.add("materials with an unknown alphaMode are opaque");
  return AlphaMode::opaque;
}

/// Index of refraction; 0 stands for a surface that reflects everything at its front.
float index_of_refraction(Document& document, const Value& ior) {
  constexpr float kReflectsAll = 1e4f;  // ((n - 1) / (n + 1))^2 = 0.9996
  const float index = ior.real(1.5f);
  if (index == 0) return kReflectsAll;
  if (index < 1) document.warnings.add("indices of refraction below 1 were set to 1");
  return std::clamp(index, 1.0f, kReflectsAll);
}

void read_extensions(Document& document, const Value& material, Material& m) {
  m.unlit = bool(material.extension("KHR_materials_unlit"));
  m.ior = index_of_refraction(document, material.extension("KHR_materials_ior")["ior"]);
  const Value transmission = material.extension("KHR_materials_transmission");
  m.transmission = transmission["transmissionFactor"].real(0);
  m.transmission_texture = read_texture(document, transmission["transmissionTexture"]);
  const Value specular = material.extension("KHR_materials_specular");
  m.specular_weight = specular["specularFactor"].real(1);
  m.specular_texture = read_texture(document, specular["specularTexture"]);
  m.specular_tint = specular["specularColorFactor"].rgb(Rgb(1));
  m.specular_tint_texture = read_texture(document, specular["specularColorTexture"]);
}

/// The metallic-roughness form of classic coefficients; what else the material says stays.
void take_physical(const Material& from, Material& m) {
  m.base_colour = from.base_colour, m.metallic = from.metallic, m.roughness = from.roughness;
  m.transmission = from.transmission, m.ior = from.ior;
  m.specular_weight = from.specular_weight, m.specular_tint = from.specular_tint;
}

/// extras.aktina: classic coefficients (docs/extras.aktina.schema.json). Where the material has a metallic-roughness
/// form, those that are not stated follow from it; where it has none, it follows from them.
void read_classic(const Value& stated, bool physical, Material& m) {
  constexpr const char* kNames[] = {"ka", "kd", "ks", "kr", "kt", "exponent", "index"};
  if (std::none_of(std::begin(kNames), std::end(kNames), [&](const char* name) { return bool(stated[name]); })) return;
  ClassicMaterial c;
  if (physical) {
    const Surface derived = surface_of(m);
    c = {derived.ka, derived.kd, derived.ks, derived.kr, derived.kt, derived.exponent, m.ior};
  }
  c.kd = stated["kd"].rgb(c.kd), c.ka = stated["ka"].rgb(physical ? c.ka : c.kd), c.ks = stated["ks"].rgb(c.ks);
  c.kr = stated["kr"].rgb(c.kr), c.kt = stated["kt"].rgb(c.kt);
  for (const Rgb k : {c.ka, c.kd, c.ks, c.kr, c.kt})
    if (!(min_channel(k) >= 0 && max_channel(k) <= 1)) stated.fail("coefficients should be from 0 to 1");
  c.exponent = stated["exponent"].real(c.exponent), c.index = stated["index"].real(c.index);
  if (!(c.exponent >= 0 && c.exponent <= 1e6f)) stated["exponent"].fail("should be from 0 to 1e6");
  if (!(c.index >= 1 && c.index <= 100)) stated["index"].fail("should be from 1 to 100");
  m.classic = c;
  if (!physical) take_physical(material_of(c), m);
}

/// KHR_materials_pbrSpecularGlossiness, the older description: a dielectric whose reflectance at normal incidence is
/// the specular colour. The glossiness in the alpha of its picture is left out.
void read_glossiness(Document& document, const Value& material, Material& m) {
  const Value old = material.extension("KHR_materials_pbrSpecularGlossiness");
  if (!old) return;
  constexpr float kDielectric = 0.04f;  // of ior 1.5, which the tint multiplies
  float base[] = {1, 1, 1, 1};
  old["diffuseFactor"].numbers(base);
  m.base_colour = {base[0], base[1], base[2]}, m.alpha = base[3];
  m.base_texture = read_texture(document, old["diffuseTexture"]);
  m.metallic = 0, m.roughness = 1 - old["glossinessFactor"].real(1), m.ior = 1.5f;
  m.metallic_roughness_texture = Texture();
  m.specular_weight = 1, m.specular_tint = old["specularFactor"].rgb(Rgb(1)) / kDielectric;
  m.specular_texture = Texture();
  m.specular_tint_texture = read_texture(document, old["specularGlossinessTexture"]);
  if (m.specular_tint_texture) document.warnings.add("the glossiness in pictures of specular colour is left out");
}

Material read_material(Document& document, const Value& material) {
  Material m;
  m.name = material["name"].text();
  read_metallic_roughness(document, material["pbrMetallicRoughness"], m);
  m.normal_texture = read_texture(document, material["normalTexture"]);
  m.normal_scale = material["normalTexture"]["scale"].real(1);
  m.occlusion_texture = read_texture(document, material["occlusionTexture"]);
  m.occlusion_strength = material["occlusionTexture"]["strength"].real(1);
  const float strength = material.extension("KHR_materials_emissive_strength")["emissiveStrength"].real(1);
  m.emission = Radiance(material["emissiveFactor"].rgb(Rgb(0)) * strength);
  m.emission_texture = read_texture(document, material["emissiveTexture"]);
  m.alpha_mode = alpha_mode(document, material["alphaMode"]);
  m.alpha_cutoff = material["alphaCutoff"].real(0.5f);
  m.double_sided = material["doubleSided"].flag(false);
  read_extensions(document, material, m);
  read_glossiness(document, material, m);
  const bool physical = material["pbrMetallicRoughness"] || material.extension("KHR_materials_pbrSpecularGlossiness") ||
                        material.extension("KHR_materials_transmission") ||
                        material.extension("KHR_materials_specular");
  read_classic(material.aktina_extras(), physical, m);
  m.original = material.json();
  return m;
}

}  // namespace

void read_materials(Document& document, Scene& scene) {
  const Value list = document.list("materials");
  for (size_t i = 0; i < list.size(); ++i) scene.materials.push_back(read_material(document, list[i]));
}

}  // namespace aktina::gltf
