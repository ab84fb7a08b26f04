// Materials, textures, samplers and images of a scene -> glTF.
#pragma once

#include <map>
#include <tuple>

#include "aktina/export/gltf_file.h"
#include "aktina/scene/scene.h"

namespace aktina::gltf_export {

class MaterialWriter {
 public:
  MaterialWriter(GltfFile& file, const Scene& scene) : file_(file), scene_(scene) {}

  /// The material as it is: metallic-roughness with the extensions that Aktina reads. What its file said beyond that
  /// (Material::original) stays, except for extensions with textures of their own.
  Json whole(const Material& material);
  /// KHR_materials_unlit: base colour and base texture, to be multiplied by the vertex colours.
  Json unlit(const Material& material);

 private:
  Json base(const Material& material);
  Json use(const Texture& texture);
  int texture(const Texture& texture);
  int sampler(const Texture& texture);
  int image(int index);
  void add_extensions(Json& json, const Material& material);
  void keep_original(Json& json, const Material& material);

  GltfFile& file_;
  const Scene& scene_;
  std::map<int, int> images_;                    // Scene::images -> glTF
  std::map<std::pair<int, int>, int> textures_;  // (image, sampler) -> texture
  std::map<std::tuple<Wrap, Wrap, Filter>, int> samplers_;
};

}  // namespace aktina::gltf_export
