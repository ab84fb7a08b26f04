#include "aktina/export/lit_gltf.h"

#include <fmt/core.h>

#include "aktina/base/version.h"
#include "aktina/export/gltf_material.h"
#include "aktina/export/gltf_scene.h"

namespace aktina {
namespace {

using gltf_export::Json;

Json asset(float exposure, const Metadata& metadata) {
  Json aktina = {{"exposure", exposure}, {"colour", "COLOR_0 = exposure * irradiance / pi, at most 1; linear"}};
  for (const auto& [name, value] : metadata) aktina[name] = value;
  return {{"version", "2.0"},
          {"generator", fmt::format("Aktina {}", version())},
          {"extras", {{"aktina", std::move(aktina)}}}};
}

void expose(Scene& lit, float exposure) {
  for (Mesh& mesh : lit.meshes)
    for (Vec4& c : mesh.colours) c = Vec4(exposure * Vec3(c), c.w);
}

/// Unlit materials first, the originals behind them: a tool that restores the original of material i reads its number
/// in materials[i].extras.aktina.original.
void add_materials(gltf_export::GltfFile& file, const Scene& original, const Scene& lit) {
  gltf_export::MaterialWriter writer(file, original);
  for (size_t i = 0; i < lit.materials.size(); ++i) {
    Json json = writer.unlit(lit.materials[i]);
    if (i < original.materials.size()) json["extras"]["aktina"]["original"] = lit.materials.size() + i;
    file.add("materials", std::move(json));
  }
  for (const Material& material : original.materials) file.add("materials", writer.whole(material));
}

}  // namespace

void write_lit_gltf(const Path& path, const Scene& original, Scene lit, float exposure, const Metadata& metadata) {
  expose(lit, exposure);
  gltf_export::GltfFile file;
  file.json["asset"] = asset(exposure, metadata);
  add_materials(file, original, lit);
  gltf_export::add_nodes(file, lit, [&](const Instance& instance) {
    return instance.material >= 0 ? instance.material : lit.meshes[size_t(instance.mesh)].material;
  });
  file.write(path);
}

}  // namespace aktina
