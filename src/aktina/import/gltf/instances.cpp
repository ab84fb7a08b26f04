// Meshes and shapes that nodes place.
#include <cmath>

#include "aktina/import/gltf/accessors.h"
#include "aktina/import/gltf/nodes.h"

namespace aktina::gltf {
namespace {

bool invertible(const Mat4& m) {
  const float determinant = glm::determinant(Mat3(m));
  return std::isfinite(determinant) && determinant != 0 && is_finite(Vec3(m[3]));
}

class InstanceReader {
 public:
  InstanceReader(Document& document, const MeshTable& meshes, Scene& scene)
      : document_(document), meshes_(meshes), scene_(scene) {}

  void read(const Value& place, int node) {
    const int mesh = place["mesh"].index(meshes_.size());
    if (mesh < 0) return;
    for (const int part : meshes_[size_t(mesh)]) add(place, {.mesh = part, .node = node, .to_world = to_world(node)});
  }

 private:
  const Mat4& to_world(int node) const { return scene_.nodes[size_t(node)].to_world; }

  void add(const Value& place, Instance instance) {
    document_.allowance.take(sizeof(Instance), place);
    if (invertible(instance.to_world))
      scene_.instances.push_back(instance);
    else
      document_.warnings.add("objects that their nodes scale to nothing, or beyond what numbers hold, were left out");
  }

  Document& document_;
  const MeshTable& meshes_;
  Scene& scene_;
};

}  // namespace

void read_instances(Document& document, const Hierarchy& hierarchy, const MeshTable& meshes, Scene& scene) {
  const Value nodes = document.list("nodes");
  InstanceReader reader(document, meshes, scene);
  for (size_t i = 0; i < scene.nodes.size(); ++i) reader.read(nodes[size_t(hierarchy.source[i])], int(i));
}

}  // namespace aktina::gltf
