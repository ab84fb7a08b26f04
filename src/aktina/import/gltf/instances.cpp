// Meshes and shapes that nodes place.
#include <algorithm>
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
    if (mesh >= 0) read_mesh(place, node, meshes_[size_t(mesh)]);
    const Value shape = place.aktina_extras()["primitive"];
    if (shape) read_shape(place, shape, node);
  }

 private:
  const Mat4& to_world(int node) const { return scene_.nodes[size_t(node)].to_world; }

  void read_mesh(const Value& place, int node, const std::vector<int>& parts) {
    const Value copies = place.extension("EXT_mesh_gpu_instancing")["attributes"];
    if (!copies) {
      for (const int part : parts) add(place, {.mesh = part, .node = node, .to_world = to_world(node)});
      return;
    }
    for (const Mat4& copy : placements(copies))
      for (const int part : parts) add(copies, {.mesh = part, .node = node, .to_world = to_world(node) * copy});
  }

  /// EXT_mesh_gpu_instancing: one transformation a copy, from parallel accessors.
  std::vector<Mat4> placements(const Value& attributes) {
    const auto translations = column(attributes["TRANSLATION"], 3), rotations = column(attributes["ROTATION"], 4),
               scales = column(attributes["SCALE"], 3);
    const size_t count = std::max({translations.size() / 3, rotations.size() / 4, scales.size() / 3});
    document_.allowance.take(count * sizeof(Mat4), attributes);
    std::vector<Mat4> out;
    for (size_t i = 0; i < count; ++i) {
      const auto at = [&](const std::vector<float>& values, size_t k, float otherwise) {
        return k < values.size() ? values[k] : otherwise;
      };
      Vec3 translation, scale;
      Vec4 rotation;
      for (size_t k = 0; k < 3; ++k) {
        translation[int(k)] = at(translations, 3 * i + k, 0), scale[int(k)] = at(scales, 3 * i + k, 1);
      }
      for (size_t k = 0; k < 4; ++k) rotation[int(k)] = at(rotations, 4 * i + k, k == 3 ? 1 : 0);
      out.push_back(compose(translation, rotation, scale));
    }
    return out;
  }

  std::vector<float> column(const Value& index, int width) {
    if (!index) return {};
    const Accessor accessor = refer_to_accessor(document_, index);
    if (accessor.width != width) index.fail("has the wrong number of components");
    document_.allowance.take(accessor.count * uint64_t(width) * sizeof(float), index);
    return read_floats(document_, accessor, 0, accessor.count);
  }

  /// extras.aktina.primitive: an analytic shape in the node's space (docs/extras.aktina.schema.json).
  void read_shape(const Value& place, const Value& shape, int node) {
    const auto size = [&](const char* name, float otherwise) {
      const float value = shape[name].real(otherwise);
      if (!(value >= 0 && value <= 1e9f)) shape[name].fail("should be from 0 to 1e9");
      return value;
    };
    const std::string_view type = shape["type"].text_view();
    if (type == "sphere")
      scene_.primitives.emplace_back(Sphere{size("radius", 1)});
    else if (type == "disc")
      scene_.primitives.emplace_back(Disc{size("radius", 1)});
    else if (type == "cylinder")
      scene_.primitives.emplace_back(Cylinder{size("radius", 0.5f), size("height", 1)});
    else if (type == "cone")
      scene_.primitives.emplace_back(Cone{size("radius", 0.5f), size("top_radius", 0), size("height", 1)});
    else
      shape["type"].fail("is not one of sphere, disc, cylinder, cone");
    add(place, {.primitive = int(scene_.primitives.size()) - 1,
                .material = shape["material"].index(scene_.materials.size()),
                .node = node,
                .to_world = to_world(node)});
  }

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
