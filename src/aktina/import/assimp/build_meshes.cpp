// Polygons over vertices of their own -> indexed triangles.
#include <cstring>
#include <unordered_map>

#include "aktina/base/random.h"
#include "aktina/image/image.h"
#include "aktina/import/assimp/build.h"
#include "aktina/import/mesh_tools.h"
#include "aktina/import/polygon.h"

namespace aktina::assimp {
namespace {

/// Joins vertices that are alike in everything.
class Welder {
 public:
  explicit Welder(const FileMesh& from) : from_(from) {}

  uint32_t vertex(uint32_t i) {
    const auto [first, last] = known_.equal_range(hash(i));
    for (auto at = first; at != last; ++at)
      if (same(from_of_[at->second], i)) return at->second;
    const auto index = uint32_t(from_of_.size());
    known_.emplace(hash(i), index);
    from_of_.push_back(i);
    return index;
  }

  void fill(Mesh& mesh) const {
    for (const uint32_t i : from_of_) {
      mesh.positions.push_back(from_.positions[i]);
      if (!from_.normals.empty()) mesh.normals.push_back(from_.normals[i]);
      for (const size_t set : {0, 1})
        if (!from_.uv[set].empty()) mesh.uv[set].emplace_back(from_.uv[set][i].x, 1 - from_.uv[set][i].y);
      if (from_.colours.empty()) continue;
      const Vec4 c = from_.colours[i];
      mesh.colours.emplace_back(srgb_to_linear(c.x), srgb_to_linear(c.y), srgb_to_linear(c.z), c.w);
    }
  }

 private:
  template <class Each>
  void attributes(uint32_t i, Each each) const {
    each(from_.positions, i), each(from_.normals, i), each(from_.uv[0], i), each(from_.uv[1], i);
    each(from_.colours, i);
  }
  uint32_t hash(uint32_t i) const {
    uint32_t h = 0;
    attributes(i, [&](const auto& list, uint32_t k) {
      if (list.empty()) return;
      uint32_t words[sizeof(list[0]) / 4];
      std::memcpy(words, &list[k], sizeof words);
      for (const uint32_t word : words) h = hash_combine(h, word);
    });
    return h;
  }
  bool same(uint32_t a, uint32_t b) const {
    bool equal = true;
    attributes(a, [&](const auto& list, uint32_t) {
      if (!list.empty()) equal &= list[a] == list[b];
    });
    return equal;
  }

  const FileMesh& from_;
  std::vector<uint32_t> from_of_;  // of each new vertex
  std::unordered_multimap<uint32_t, uint32_t> known_;
};

Mesh build_mesh(const FileMesh& from, Triangulator& cutter) {
  Mesh mesh;
  mesh.name = from.name, mesh.material = from.material;
  Welder welder(from);
  std::vector<Point3> outline;
  size_t first = 0;
  for (const uint32_t size : from.sizes) {
    outline.clear();
    for (size_t i = first; i < first + size; ++i) outline.push_back(from.positions[from.corners[i]]);
    for (const auto& t : cutter.triangulate(outline)) {
      const auto corner = [&](int k) { return welder.vertex(from.corners[first + t[size_t(k)]]); };
      mesh.triangles.push_back({corner(0), corner(1), corner(2)});
      mesh.triangle_face.push_back(mesh.face_count);
    }
    ++mesh.face_count;
    first += size;
  }
  welder.fill(mesh);
  return mesh;
}

}  // namespace

void build_meshes(Document& document, const ImportOptions& options, Scene& scene) {
  std::vector<std::vector<int>> nodes(document.meshes.size());
  for (const FileMeshUse& use : document.uses) nodes[size_t(use.mesh)].push_back(use.node);
  Triangulator cutter;
  for (size_t i = 0; i < document.meshes.size(); ++i) {
    if (nodes[i].empty()) continue;
    Mesh mesh = build_mesh(document.meshes[i], cutter);
    document.meshes[i] = {};  // the memory is needed
    const size_t before = scene.instances.size();
    add_mesh(scene, std::move(mesh), options, nodes[i][0]);
    if (scene.instances.size() == before) continue;
    for (size_t k = 1; k < nodes[i].size(); ++k) {
      Instance instance = scene.instances[before];
      instance.node = nodes[i][k];
      instance.to_world = scene.nodes[size_t(instance.node)].to_world;
      scene.instances.push_back(instance);
    }
  }
  scene.warnings.add("polygons that cross themselves were cut into fans", cutter.given_up());
}

}  // namespace aktina::assimp
