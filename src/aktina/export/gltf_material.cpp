#include "aktina/export/gltf_material.h"

#include <algorithm>

#include "aktina/image/codec.h"

namespace aktina::gltf_export {
namespace {

constexpr int kNearest = 9728, kLinear = 9729, kLinearMipmapLinear = 9987;

int wrap_code(Wrap wrap) { return wrap == Wrap::clamp ? 33071 : wrap == Wrap::mirror ? 33648 : 10497; }

Json array(Rgb c) { return {c.r, c.g, c.b}; }

bool is_webp(const TextureImage& image) { return detect_image_format(image.encoded) == ImageFormat::webp; }

/// The file's own bytes, or a PNG where glTF does not know their format.
std::vector<uint8_t> encoded(const TextureImage& image, std::string& media_type) {
  const ImageFormat format = detect_image_format(image.encoded);
  media_type = format == ImageFormat::jpeg ? "image/jpeg" : format == ImageFormat::webp ? "image/webp" : "image/png";
  if (format == ImageFormat::png || media_type != "image/png") return image.encoded;
  Image pixels(image.width(), image.height(), 4);
  for (int y = 0; y < pixels.height; ++y)
    for (int x = 0; x < pixels.width; ++x) {
      const Vec2 uv((float(x) + 0.5f) / float(pixels.width), (float(y) + 0.5f) / float(pixels.height));
      const Vec4 texel = look_up(image, {.image = 0}, uv, true);
      std::copy_n(&texel.x, 4, pixels.at(x, y));
    }
  LayeredImage picture;
  picture.layers.push_back({"", std::move(pixels)});
  ImageWriteOptions options;
  options.tone_mapping.exposure = 1;
  return png_codec.encode(picture, options);
}

bool refers_to_texture(const Json& json) {
  if (json.is_object() && json.contains("index")) return true;
  return json.is_structured() && std::any_of(json.begin(), json.end(), refers_to_texture);
}

void add_alpha(Json& json, const Material& m) {
  if (m.alpha_mode == AlphaMode::mask) json["alphaMode"] = "MASK", json["alphaCutoff"] = m.alpha_cutoff;
  if (m.alpha_mode == AlphaMode::blend) json["alphaMode"] = "BLEND";
  if (m.double_sided) json["doubleSided"] = true;
}

Json classic_json(const ClassicMaterial& c) {
  return {{"ka", array(c.ka)}, {"kd", array(c.kd)},      {"ks", array(c.ks)}, {"kr", array(c.kr)},
          {"kt", array(c.kt)}, {"exponent", c.exponent}, {"index", c.index}};
}

}  // namespace

int MaterialWriter::image(int index) {
  const auto [found, fresh] = images_.try_emplace(index, 0);
  if (!fresh) return found->second;
  const TextureImage& source = scene_.images[size_t(index)];
  Json json;
  if (!source.name.empty()) json["name"] = source.name;
  std::string media_type;
  json["bufferView"] = file_.view(encoded(source, media_type));
  json["mimeType"] = media_type;
  return found->second = file_.add("images", std::move(json));
}

int MaterialWriter::sampler(const Texture& t) {
  const auto [found, fresh] = samplers_.try_emplace({t.wrap_u, t.wrap_v, t.filter}, 0);
  if (!fresh) return found->second;
  const bool nearest = t.filter == Filter::nearest;
  return found->second = file_.add("samplers", {{"magFilter", nearest ? kNearest : kLinear},
                                                {"minFilter", nearest ? kNearest : kLinearMipmapLinear},
                                                {"wrapS", wrap_code(t.wrap_u)},
                                                {"wrapT", wrap_code(t.wrap_v)}});
}

int MaterialWriter::texture(const Texture& t) {
  const int samples = sampler(t);
  const auto [found, fresh] = textures_.try_emplace({t.image, samples}, 0);
  if (!fresh) return found->second;
  Json json = {{"sampler", samples}};
  const int source = image(t.image);
  if (is_webp(scene_.images[size_t(t.image)])) {
    file_.use("EXT_texture_webp");
    json["extensions"]["EXT_texture_webp"]["source"] = source;
  } else {
    json["source"] = source;
  }
  return found->second = file_.add("textures", std::move(json));
}

Json MaterialWriter::use(const Texture& t) {
  Json json = {{"index", texture(t)}};
  if (t.uv_set != 0) json["texCoord"] = t.uv_set;
  if (t.offset == Vec2(0) && t.scale == Vec2(1) && t.rotation == 0) return json;
  file_.use("KHR_texture_transform");
  json["extensions"]["KHR_texture_transform"] = {
      {"offset", {t.offset.x, t.offset.y}}, {"rotation", t.rotation}, {"scale", {t.scale.x, t.scale.y}}};
  return json;
}

Json MaterialWriter::base(const Material& m) {
  Json pbr = {{"baseColorFactor", {m.base_colour.r, m.base_colour.g, m.base_colour.b, m.alpha}}};
  if (m.base_texture) pbr["baseColorTexture"] = use(m.base_texture);
  return pbr;
}

Json MaterialWriter::unlit(const Material& m) {
  file_.use("KHR_materials_unlit");
  Json json;
  if (!m.name.empty()) json["name"] = m.name;
  json["pbrMetallicRoughness"] = base(m);  // matt, for viewers that do not know the extension
  json["pbrMetallicRoughness"].update({{"metallicFactor", 0}, {"roughnessFactor", 1}});
  add_alpha(json, m);
  json["extensions"]["KHR_materials_unlit"] = Json::object();
  return json;
}

void MaterialWriter::add_extensions(Json& json, const Material& m) {
  const auto extension = [&](std::string_view name) -> Json& {
    file_.use(name);
    return json["extensions"][std::string(name)] = Json::object();
  };
  if (m.unlit) extension("KHR_materials_unlit");
  if (max_channel(m.emission.v) > 1)
    extension("KHR_materials_emissive_strength")["emissiveStrength"] = max_channel(m.emission.v);
  if (m.ior != 1.5f) extension("KHR_materials_ior")["ior"] = m.ior;
  if (m.transmission > 0) {
    Json& transmission = extension("KHR_materials_transmission");
    transmission["transmissionFactor"] = m.transmission;
    if (m.transmission_texture) transmission["transmissionTexture"] = use(m.transmission_texture);
  }
  if (m.specular_weight != 1 || m.specular_tint != Rgb(1) || m.specular_texture || m.specular_tint_texture) {
    Json& specular = extension("KHR_materials_specular");
    specular["specularFactor"] = m.specular_weight;
    specular["specularColorFactor"] = array(m.specular_tint);
    if (m.specular_texture) specular["specularTexture"] = use(m.specular_texture);
    if (m.specular_tint_texture) specular["specularColorTexture"] = use(m.specular_tint_texture);
  }
}

void MaterialWriter::keep_original(Json& json, const Material& m) {
  const Json original = Json::parse(m.original, nullptr, false);
  if (!original.is_object()) return;
  if (original.contains("extras")) json["extras"] = original["extras"];
  if (!original.contains("extensions") || !original["extensions"].is_object()) return;
  for (const auto& [name, value] : original["extensions"].items()) {
    if ((json.contains("extensions") && json["extensions"].contains(name)) || refers_to_texture(value)) continue;
    file_.use(name);
    json["extensions"][name] = value;
  }
}

Json MaterialWriter::whole(const Material& m) {
  Json json;
  if (!m.name.empty()) json["name"] = m.name;
  Json& pbr = json["pbrMetallicRoughness"] = base(m);
  pbr["metallicFactor"] = m.metallic, pbr["roughnessFactor"] = m.roughness;
  if (m.metallic_roughness_texture) pbr["metallicRoughnessTexture"] = use(m.metallic_roughness_texture);
  if (m.normal_texture) {
    json["normalTexture"] = use(m.normal_texture);
    json["normalTexture"]["scale"] = m.normal_scale;
  }
  if (m.occlusion_texture) {
    json["occlusionTexture"] = use(m.occlusion_texture);
    json["occlusionTexture"]["strength"] = m.occlusion_strength;
  }
  if (m.emits()) json["emissiveFactor"] = array(m.emission.v / std::max(1.0f, max_channel(m.emission.v)));
  if (m.emission_texture) json["emissiveTexture"] = use(m.emission_texture);
  add_alpha(json, m);
  add_extensions(json, m);
  keep_original(json, m);
  if (m.classic) json["extras"]["aktina"].update(classic_json(*m.classic));
  return json;
}

}  // namespace aktina::gltf_export
