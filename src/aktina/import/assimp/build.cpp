#include "aktina/import/assimp/build.h"

#include <cmath>

#include "aktina/base/error.h"

namespace aktina::assimp {
namespace {

bool is_finite(const Mat4& m) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(m[c][r])) return false;
  return true;
}

void build_nodes(Document& document, float scale, Scene& scene) {
  for (FileNode& from : document.nodes) {
    Node node;
    node.name = std::move(from.name), node.parent = from.parent, node.local = from.local;
    node.local[0][3] = node.local[1][3] = node.local[2][3] = 0, node.local[3][3] = 1;
    if (node.parent < 0)
      for (int c = 0; c < 4; ++c) node.local[c] = Vec4(Vec3(node.local[c]) * scale, node.local[c][3]);
    node.to_world = node.parent < 0 ? node.local : scene.nodes[size_t(node.parent)].to_world * node.local;
    if (!is_finite(node.to_world)) {
      scene.warnings.add("nodes whose place is not finite were put at the origin");
      node.local = node.to_world = Mat4(1);
      node.parent = -1;
    }
    scene.nodes.push_back(std::move(node));
  }
}

}  // namespace

void build(Document document, Beside& beside, const ImportOptions& options, Scene& scene) {
  for (const FileWarning& warning : document.warnings) scene.warnings.add(one_line(warning.text), warning.count);
  const double units = options.metres_per_unit > 0 ? options.metres_per_unit : document.metres_per_unit;
  scene.generator = document.generator;
  scene.metres_per_unit = units;
  build_nodes(document, float(units / document.metres_per_unit), scene);
  build_materials(document, beside, scene);
  build_meshes(document, options, scene);
  build_lights(document, units, scene);
  build_cameras(document, units, scene);
}

}  // namespace aktina::assimp
