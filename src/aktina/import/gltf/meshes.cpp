#include "aktina/import/gltf/meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "aktina/import/gltf/accessors.h"
#include "aktina/import/gltf/draco.h"
#include "aktina/import/repair.h"

namespace aktina::gltf {
namespace {

constexpr uint64_t kTriangleList = 4, kTriangleFan = 6, kTriangleStrip = 5;
constexpr uint64_t kVertexBytes = sizeof(Point3) + sizeof(Vec3) + sizeof(Vec2);

/// Vertices [low, low + count) of the accessors that a primitive's indices name.
struct Range {
  uint64_t low = 0, count = 0;
};

class PrimitiveReader {
 public:
  PrimitiveReader(Document& document, const Value& primitive) : document_(document), primitive_(primitive) {}

  /// @return a mesh that may be empty
  Mesh read() {
    Mesh mesh;
    const uint64_t mode = primitive_["mode"].whole(kTriangleList);
    if (mode > kTriangleFan) primitive_["mode"].fail("is not one of 0 to 6");
    if (mode < kTriangleList) {
      document_.warnings.add("primitives of points or lines, which have no surface, were left out");
      return mesh;
    }
    const Value position = primitive_["attributes"]["POSITION"];
    if (!position) {
      document_.warnings.add("primitives without positions were left out");
      return mesh;
    }
    if (primitive_.extension("KHR_draco_mesh_compression")) {
      mesh = unpack_draco(document_, primitive_);
      note_unread();
      repair(mesh, document_.warnings, mode == kTriangleStrip);
      return mesh;
    }
    vertices_ = open(position, 3, 3).count;
    mesh.triangles = triangulate(read_indices(), mode);
    const Range range = move_to_used(mesh);
    read_attributes(mesh, range);
    repair(mesh, document_.warnings, mode == kTriangleStrip);
    return mesh;
  }

 private:
  Accessor open(const Value& index, int least_width, int most_width) {
    Accessor accessor = refer_to_accessor(document_, index);
    if (accessor.width < least_width || accessor.width > most_width)
      index.fail(fmt::format("has {} numbers an element", accessor.width));
    return accessor;
  }

  std::vector<uint32_t> read_indices() {
    const Value place = primitive_["indices"];
    if (place) {
      const Accessor accessor = refer_to_accessor(document_, place);
      document_.allowance.take(accessor.count * 4 * sizeof(uint32_t), place);
      return read_whole(document_, accessor);
    }
    document_.allowance.take(vertices_ * 4 * sizeof(uint32_t), primitive_);
    std::vector<uint32_t> indices(size_t(vertices_), 0);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
  }

  /// Several primitives often share one long list of vertices: only the stretch that this one uses is read.
  Range move_to_used(Mesh& mesh) {
    uint64_t low = vertices_, high = 0;
    for (const auto& triangle : mesh.triangles)
      for (const uint64_t i : triangle)
        if (i < vertices_) low = std::min(low, i), high = std::max(high, i + 1);
    if (low >= high) low = high = 0;
    for (auto& triangle : mesh.triangles)
      for (uint32_t& i : triangle) i = i >= low && i < vertices_ ? uint32_t(i - low) : UINT32_MAX;
    return {low, high - low};
  }

  void read_attributes(Mesh& mesh, Range range) {
    const Value attributes = primitive_["attributes"];
    document_.allowance.take(range.count * kVertexBytes, primitive_);
    read(mesh.positions, attributes["POSITION"], range);
    read(mesh.normals, attributes["NORMAL"], range);
    if (!mesh.normals.empty()) read(mesh.tangents, attributes["TANGENT"], range);
    read(mesh.uv[0], attributes["TEXCOORD_0"], range);
    read(mesh.uv[1], attributes["TEXCOORD_1"], range);
    read_colours(mesh, attributes["COLOR_0"], range);
    note_unread();
  }

  void note_unread() {
    const Value attributes = primitive_["attributes"];
    if (attributes["TEXCOORD_2"] || attributes["COLOR_1"])
      document_.warnings.add("texture coordinates beyond set 1 or colours beyond set 0 were left out");
  }

  Accessor open_as_long(const Value& place, int least_width, int most_width) {
    Accessor accessor = open(place, least_width, most_width);
    if (accessor.count != vertices_)
      place.fail(fmt::format("has {} elements, POSITION has {}", accessor.count, vertices_));
    return accessor;
  }

  template <class V>
  void read(std::vector<V>& out, const Value& place, Range range) {
    if (!place) return;
    const Accessor accessor = open_as_long(place, V::length(), V::length());
    const std::vector<float> numbers = read_floats(document_, accessor, range.low, range.count);
    out.resize(size_t(range.count));
    for (size_t i = 0; i < out.size(); ++i)
      for (int k = 0; k < V::length(); ++k) out[i][k] = numbers[i * size_t(V::length()) + size_t(k)];
  }

  void read_colours(Mesh& mesh, const Value& place, Range range) {
    if (!place) return;
    Accessor accessor = open_as_long(place, 3, 4);
    accessor.normalized = true;
    document_.allowance.take(range.count * sizeof(Vec4), place);
    const std::vector<float> numbers = read_floats(document_, accessor, range.low, range.count);
    mesh.colours.assign(size_t(range.count), Vec4(1));
    for (size_t i = 0; i < mesh.colours.size(); ++i)
      for (int k = 0; k < accessor.width; ++k) mesh.colours[i][k] = numbers[i * size_t(accessor.width) + size_t(k)];
  }

  Document& document_;
  Value primitive_;
  uint64_t vertices_ = 0;
};

void complete(Mesh& mesh, Document& document, const Value& primitive, const Scene& scene) {
  if (mesh.normals.empty()) {
    document.allowance.take(mesh.triangles.size() * 3 * kVertexBytes, primitive);
    generate_normals(mesh, 0);
  }
  if (mesh.material < 0) return;
  const Texture& normals = scene.materials[size_t(mesh.material)].normal_texture;
  if (normals && mesh.tangents.empty()) {
    document.allowance.take(mesh.positions.size() * 3 * sizeof(Vec4), primitive);
    generate_tangents(mesh, normals.uv_set);
  }
}

}  // namespace

MeshTable read_meshes(Document& document, const std::vector<bool>& used, Scene& scene) {
  const Value list = document.list("meshes");
  MeshTable table(list.size());
  for (size_t i = 0; i < list.size(); ++i) {
    if (!used[i]) {
      document.warnings.add("meshes that no node of the scene shows were left out");
      continue;
    }
    const Value primitives = list[i]["primitives"];
    for (size_t k = 0; k < primitives.size(); ++k) {
      Mesh mesh = PrimitiveReader(document, primitives[k]).read();
      if (mesh.triangles.empty()) continue;
      mesh.name = list[i]["name"].text();
      mesh.material = primitives[k]["material"].index(scene.materials.size());
      complete(mesh, document, primitives[k], scene);
      table[i].push_back(int(scene.meshes.size()));
      scene.meshes.push_back(std::move(mesh));
    }
  }
  return table;
}

}  // namespace aktina::gltf
