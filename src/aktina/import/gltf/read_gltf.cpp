// glTF 2.0 (ISO/IEC 12113) -> Scene, by a mapping of our own over the parsed JSON.
#include <fmt/format.h>

#include <cmath>

#include "aktina/image/file_format.h"
#include "aktina/import/environment.h"
#include "aktina/import/gltf/check_data.h"
#include "aktina/import/gltf/document.h"
#include "aktina/import/gltf/materials.h"
#include "aktina/import/gltf/nodes.h"
#include "aktina/import/import.h"

namespace aktina {
namespace {

using gltf::Document;
using gltf::Hierarchy;
using gltf::Value;

std::vector<bool> used_meshes(const Document& document, const Hierarchy& hierarchy) {
  const Value nodes = document.list("nodes");
  std::vector<bool> used(document.list("meshes").size(), false);
  for (const int node : hierarchy.source) {
    const int mesh = nodes[size_t(node)]["mesh"].index(used.size());
    if (mesh >= 0) used[size_t(mesh)] = true;
  }
  return used;
}

/// extras.aktina: a picture of the surroundings, beside the file or within it.
void read_environment(Document& document, const Value& stated, Scene& scene) {
  if (!stated) return;
  const Rgb scale = stated["scale"].rgb(Rgb(1));
  const float rotation = stated["rotation"].real(0);
  if (!(is_finite(scale) && min_channel(scale) >= 0 && std::isfinite(rotation)))
    stated.fail("scale should be finite and not below 0, rotation finite");
  if (!stated["uri"]) {
    scene.environment.colour = Radiance(scale);
    return;
  }
  const std::vector<uint8_t> bytes = fetch(document, stated["uri"]);
  const ImageHeader header = read_image_header(bytes, stated["uri"].place());
  document.allowance.take(uint64_t(header.width) * uint64_t(header.height) * 3 * sizeof(float), stated);
  scene.environment = environment_of(bytes, stated["uri"].place(), scale, rotation, document.warnings);
}

}  // namespace

Scene read_gltf(std::span<const uint8_t> bytes, const Path& folder, const std::string& where,
                const ImportOptions& options) {
  Document document(bytes, folder, where, options);
  Scene scene;
  scene.source = where;
  scene.generator = document.root()["asset"]["generator"].text();
  read_materials(document, scene);
  read_images(document, scene);
  const Hierarchy hierarchy = read_nodes(document, scene);
  const gltf::MeshTable meshes = read_meshes(document, used_meshes(document, hierarchy), scene);
  read_instances(document, hierarchy, meshes, scene);
  read_cameras(document, hierarchy, scene);
  read_lights(document, hierarchy, scene);
  read_luminaires(document, hierarchy, scene);
  const Value extras = document.root().aktina_extras();
  scene.ambient = extras["ambient"].rgb(Rgb(0));
  scene.background = Radiance(extras["background"].rgb(Rgb(0)));
  for (const Rgb light : {scene.ambient, scene.background.v})
    if (!is_finite(light) || min_channel(light) < 0)
      extras.fail("ambient and background should be finite and not below 0");
  read_environment(document, extras["environment"], scene);
  check_data(document);
  scene.warnings = document.warnings;
  if (options.default_camera) add_default_camera(scene);
  if (options.default_light) add_default_light(scene);
  return scene;
}

}  // namespace aktina
