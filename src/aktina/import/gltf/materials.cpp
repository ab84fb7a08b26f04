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
  m.original = material.json();
  return m;
}

}  // namespace

void read_materials(Document& document, Scene& scene) {
  const Value list = document.list("materials");
  for (size_t i = 0; i < list.size(); ++i) scene.materials.push_back(read_material(document, list[i]));
}

}  // namespace aktina::gltf
