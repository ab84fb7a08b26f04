#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "aktina/base/error.h"
#include "aktina/base/random.h"
#include "aktina/base/version.h"
#include "aktina/export/gltf_material.h"
#include "aktina/export/gltf_scene.h"
#include "aktina/export/lightmap_files.h"
#include "aktina/image/codec.h"
#include "aktina/radiosity/lightmap/texel_material.h"
#include "aktina/scene/tessellate.h"

namespace aktina {
namespace {

using gltf_export::GltfFile;
using gltf_export::Json;
using gltf_export::MaterialWriter;

constexpr std::string_view kExtension = "MOZ_lightmap";

std::vector<uint8_t> png(Image image) {
  LayeredImage picture;
  picture.layers.push_back({"", std::move(image)});
  ImageWriteOptions options;
  options.tone_mapping.exposure = 1;
  return png_codec.encode(picture, options);
}

/// Numbers in [0, 1] as bytes that stand for themselves, not for sRGB codes. What lies between two bytes becomes one or
/// the other by chance, as often as it is near it: dark surfaces have no bands.
Image linear_codes(Image image) {
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    const float chance = unit_float(hash32(uint32_t(i)));
    const float byte = std::floor(std::clamp(image.pixels[i], 0.0f, 1.0f) * 255 + chance);
    image.pixels[i] = srgb_to_linear(std::min(byte, 255.0f) / 255);
  }
  return image;
}

/// How much brighter than 1 a surface of this material shines by itself, exposed.
float strength(const Material& m, float exposure) { return std::max(1.0f, exposure * max_channel(m.emission.v)); }

/// What surfaces send to the eye, exposed, over the strength of their material.
std::vector<Image> radiance_pages(const Scene& scene, const Lightmap& map, float exposure) {
  const TessellatedScene tessellated(scene);
  const LightmapLayout& layout = map.layout;
  const TexelMaterials materials = texel_materials(*tessellated, layout, map.texels);
  std::vector<Rgb> reflected(map.texels.size()), emitted(map.texels.size());
  for (size_t i = 0; i < map.texels.size(); ++i) {
    const uint32_t instance = layout.surfaces[layout.charts[map.texels[i].chart].surface].instance;
    const float share = exposure / strength(tessellated->material_of(tessellated->instances[instance]), exposure);
    reflected[i] = materials.reflectances[i] * (share * float(kInvPi));
    emitted[i] = materials.emissions[i].v * share;
  }
  std::vector<Image> pages = texel_pages(layout, map.texels, reflected);
  const std::vector<Image> own = texel_pages(layout, map.texels, emitted);
  for (size_t p = 0; p < pages.size(); ++p)
    for (size_t i = 0; i < pages[p].pixels.size(); ++i)
      pages[p].pixels[i] = pages[p].pixels[i] * map.irradiances[p].pixels[i] + own[p].pixels[i];
  return pages;
}

std::vector<Image> exposed_pages(const Lightmap& map, float exposure) {
  std::vector<Image> pages = map.irradiances;
  for (Image& page : pages)
    for (float& value : page.pixels) value *= exposure * float(kInvPi);
  return pages;
}

/// Textures are few texels wide where two charts meet: no mipmaps, no wrapping.
int page_texture(GltfFile& file, const std::vector<uint8_t>& encoded, size_t page) {
  constexpr int kLinear = 9729, kClamp = 33071;
  const int image = file.add(
      "images",
      {{"name", fmt::format("lightmap {}", page)}, {"bufferView", file.view(encoded)}, {"mimeType", "image/png"}});
  const int sampler =
      file.add("samplers", {{"magFilter", kLinear}, {"minFilter", kLinear}, {"wrapS", kClamp}, {"wrapT", kClamp}});
  return file.add("textures", {{"sampler", sampler}, {"source", image}});
}

/// The materials of a lightmapped scene: one for each material of the scene, page and side that is in use.
class Materials {
 public:
  Materials(GltfFile& file, const LightmappedScene& mapped, LightmapForm form, float exposure,
            const std::vector<int>& textures)
      : file_(file),
        mapped_(mapped),
        writer_(file, mapped.scene),
        form_(form),
        exposure_(exposure),
        textures_(textures) {
    for (size_t i = 0; i < mapped.backs.size(); ++i)
      if (mapped.backs[i]) layered_.insert(mapped.sources[i]);
  }

  int of(size_t instance) {
    const Instance& placed = mapped_.scene.instances[instance];
    const int material = placed.material >= 0 ? placed.material : mapped_.scene.meshes[size_t(placed.mesh)].material;
    const auto [at, is_new] = known_.try_emplace({material, mapped_.pages[instance], layered(instance)}, 0);
    if (is_new) {
      at->second = file_.add("materials", make(instance, mapped_.scene.material_of(placed)));
      originals_.push_back(material);
    }
    return at->second;
  }

  /// The scene's own materials, behind those in use, which get their numbers.
  void add_originals(const Scene& original) {
    const size_t first = originals_.size();
    for (size_t i = 0; i < first; ++i)
      if (originals_[i] >= 0)
        file_.json["materials"][i]["extras"]["aktina"]["original"] = first + size_t(originals_[i]);
    for (const Material& material : original.materials) file_.add("materials", writer_.whole(material));
  }

 private:
  /// Both sides are layers of their own: the material need not show two.
  bool layered(size_t instance) const { return layered_.contains(mapped_.sources[instance]); }

  Json make(size_t instance, const Material& material) {
    const Json map = {{"index", textures_[size_t(mapped_.pages[instance])]}, {"texCoord", 1}};
    Json json = form_ == LightmapForm::emissive ? emissive(material, map) : with_lightmap(material, map);
    if (layered(instance)) json.erase("doubleSided");
    return json;
  }

  Json emissive(const Material& material, const Json& map) {
    Material black = material;
    black.base_colour = Rgb(0), black.metallic = 0, black.roughness = 1, black.specular_weight = 0;
    black.metallic_roughness_texture = black.normal_texture = black.occlusion_texture = black.emission_texture = {};
    black.specular_texture = black.specular_tint_texture = {};
    black.specular_tint = Rgb(1), black.transmission = 0, black.ior = 1.5f, black.unlit = false;
    if (material.alpha_mode == AlphaMode::opaque) black.base_texture = {};
    black.emission = Radiance(Rgb(strength(material, exposure_)));
    black.original.clear(), black.classic.reset();
    Json json = writer_.whole(black);
    json["emissiveTexture"] = map;
    return json;
  }

  Json with_lightmap(const Material& material, const Json& map) {
    Material exposed = material;
    exposed.emission.v = exposed.emission.v * exposure_;
    const bool takes_light = !material.unlit;
    Json json = writer_.whole(exposed);
    if (!takes_light) return json;
    file_.use(kExtension);
    Json& extension = json["extensions"][std::string(kExtension)] = map;
    extension["intensity"] = kPi;
    return json;
  }

  GltfFile& file_;
  const LightmappedScene& mapped_;
  MaterialWriter writer_;
  LightmapForm form_;
  float exposure_;
  const std::vector<int>& textures_;
  std::map<std::tuple<int, int, bool>, int> known_;
  std::vector<int> originals_;
  std::set<uint32_t> layered_;
};

/// Their light is in the map: viewers must not add it a second time.
void put_out_lights(Json& json) {
  if (!json.contains("extensions")) return;
  for (Json& light : json["extensions"]["KHR_lights_punctual"]["lights"]) {
    light["extras"]["aktina"]["intensity"] = light["intensity"];
    light["intensity"] = 0;
  }
}

Json asset(const Lightmap& map, LightmapForm form, float exposure, const Metadata& metadata) {
  const bool emissive = form == LightmapForm::emissive;
  Json aktina = {{"exposure", exposure},
                 {"form", emissive ? "emissive" : "lightmap"},
                 {"colour", emissive ? "emissiveTexture * strength = exposure * radiance; sRGB"
                                     : "MOZ_lightmap * intensity = exposure * irradiance; linear"},
                 {"texel_size", map.layout.texel_size}};
  for (const auto& [name, value] : metadata) aktina[name] = value;
  return {{"version", "2.0"},
          {"generator", fmt::format("Aktina {}", version())},
          {"extras", {{"aktina", std::move(aktina)}}}};
}

}  // namespace

void write_lightmapped_gltf(const Path& path, const Scene& scene, const Solution& solution, const Lightmap& map,
                            LightmapForm form, const LitGltfOptions& options) {
  const float exposure = options.exposure > 0 ? options.exposure : lit_exposure(solution);
  const bool emissive = form == LightmapForm::emissive;
  const LightmappedScene mapped = lightmapped_scene(scene, map);
  GltfFile file;
  file.json["asset"] = asset(map, form, exposure, options.metadata);
  std::vector<Image> pages = emissive ? radiance_pages(scene, map, exposure) : exposed_pages(map, exposure);
  std::vector<int> textures;
  for (Image& page : pages)
    textures.push_back(
        page_texture(file, png(emissive ? std::move(page) : linear_codes(std::move(page))), textures.size()));
  Materials materials(file, mapped, form, exposure, textures);
  std::vector<int> material_of;
  for (size_t i = 0; i < mapped.scene.instances.size(); ++i) material_of.push_back(materials.of(i));
  materials.add_originals(scene);
  gltf_export::add_nodes(file, mapped.scene, [&](const Instance& instance) {
    return material_of[size_t(&instance - mapped.scene.instances.data())];
  });
  if (!emissive) put_out_lights(file.json);
  file.write(path);
}

}  // namespace aktina
