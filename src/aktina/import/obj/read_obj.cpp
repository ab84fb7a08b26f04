// OBJ -> Scene: objects and groups become nodes; each material of one becomes a mesh.
#include <fmt/core.h>

#include <algorithm>
#include <unordered_map>

#include "aktina/base/error.h"
#include "aktina/base/random.h"
#include "aktina/import/mesh_tools.h"
#include "aktina/import/obj/obj.h"
#include "aktina/import/polygon.h"
#include "aktina/import/repair.h"
#include "aktina/import/text.h"

namespace aktina {
namespace {

using obj::Corner;
using obj::File;
using obj::kNone;
using obj::Part;

struct CornerHash {
  size_t operator()(const Corner& c) const {
    return hash_combine(hash_combine(hash32(uint32_t(c.position)), uint32_t(c.uv)), uint32_t(c.normal));
  }
};
struct SameCorner {
  bool operator()(const Corner& a, const Corner& b) const {
    return a.position == b.position && a.uv == b.uv && a.normal == b.normal;
  }
};

/// Builds the mesh of one part: a vertex for each different corner.
class PartMesh {
 public:
  PartMesh(const File& file, const Part& part, Triangulator& cutter, Warnings& warnings)
      : file_(file), part_(part), cutter_(cutter), warnings_(warnings) {
    use_uv_ = std::any_of(part.corners.begin(), part.corners.end(),
                          [&](const Corner& c) { return within(c.uv, file.uvs.size()); });
  }

  Mesh build() {
    size_t first = 0;
    for (const uint32_t size : part_.sizes) {
      add_face(std::span(part_.corners).subspan(first, size));
      first += size;
    }
    return std::move(mesh_);
  }

 private:
  static bool within(int64_t index, size_t size) { return index >= 0 && uint64_t(index) < size; }

  void add_face(std::span<const Corner> face) {
    for (const Corner& c : face)
      if (!within(c.position, file_.positions.size()))
        return warnings_.add("faces with vertex indices out of range were dropped");
    outline_.clear();
    for (const Corner& c : face) outline_.push_back(file_.positions[size_t(c.position)]);
    const uint32_t id = mesh_.face_count++;
    for (const auto& t : cutter_.triangulate(outline_)) {
      mesh_.triangles.push_back({vertex(face[t[0]]), vertex(face[t[1]]), vertex(face[t[2]])});
      mesh_.triangle_face.push_back(id);
    }
  }

  uint32_t vertex(Corner c) {
    if (!within(c.uv, file_.uvs.size())) {
      if (c.uv != kNone) warnings_.add("texture coordinate indices out of range were taken as 0");
      c.uv = kNone;
    }
    if (!part_.has_normals) c.normal = kNone;
    const auto [at, fresh] = vertices_.try_emplace(c, uint32_t(mesh_.positions.size()));
    if (!fresh) return at->second;
    mesh_.positions.push_back(file_.positions[size_t(c.position)]);
    if (!file_.colours.empty()) mesh_.colours.push_back(file_.colours[size_t(c.position)]);
    if (use_uv_) mesh_.uv[0].push_back(c.uv == kNone ? Vec2(0) : file_.uvs[size_t(c.uv)]);
    if (part_.has_normals) {  // repair() replaces zero by the faces' own
      const bool there = within(c.normal, file_.normals.size());
      mesh_.normals.push_back(there ? file_.normals[size_t(c.normal)] : Vec3(0));
    }
    return at->second;
  }

  const File& file_;
  const Part& part_;
  Triangulator& cutter_;
  Warnings& warnings_;
  bool use_uv_ = false;
  Mesh mesh_;
  std::vector<Point3> outline_;
  std::unordered_map<Corner, uint32_t, CornerHash, SameCorner> vertices_;
};

/// A mtllib line names one file with blanks in it, or several files.
void read_libraries(const File& file, Beside& beside, Scene& scene, std::map<std::string, int>& index) {
  const auto read = [&](const std::string& name) {
    const std::optional<Path> path = beside.find(name);
    if (!path) return false;
    obj::read_mtl(decode_text(beside.read(*path)), display(*path), beside, scene, index);
    return true;
  };
  for (const std::string& line : file.libraries) {
    if (read(line)) continue;
    std::string_view rest = line;
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest))
      if (!read(std::string(word)))
        scene.warnings.add(fmt::format("material library '{}' is missing: its materials are matt grey", word));
  }
}

/// Faces of a smoothing group are smooth however sharp the edges; without smoothing each face is flat.
float crease_of(const Part& part, const ImportOptions& options) {
  return part.smoothing < 0 ? options.crease : part.smoothing == 0 ? 0 : float(kPi);
}

class Builder {
 public:
  Builder(const File& file, Scene& scene, const ImportOptions& options, const std::map<std::string, int>& materials)
      : file_(file), scene_(scene), options_(options), materials_(materials) {}

  void run() {
    std::map<std::pair<int, int>, size_t> known;  // (node, material) -> mesh
    std::vector<Mesh> meshes;
    std::vector<int> nodes;
    for (const Part& part : file_.parts) {
      const int node = node_of(part), material = material_of(part);
      const auto [at, fresh] = known.try_emplace({node, material}, meshes.size());
      if (fresh) meshes.emplace_back().material = material, nodes.push_back(node);
      Mesh more = PartMesh(file_, part, cutter_, scene_.warnings).build();
      repair(more, scene_.warnings);
      generate_normals(more, crease_of(part, options_));
      append(meshes[at->second], more);
    }
    for (size_t i = 0; i < meshes.size(); ++i) {
      meshes[i].name = nodes[i] >= 0 ? scene_.nodes[size_t(nodes[i])].name : "";
      add_mesh(scene_, std::move(meshes[i]), options_, nodes[i]);
    }
    scene_.warnings.add("polygons that cross themselves were cut into fans", cutter_.given_up());
  }

 private:
  int material_of(const Part& part) {
    if (part.material.empty()) return -1;
    const auto found = materials_.find(part.material);
    if (found != materials_.end()) return found->second;
    scene_.warnings.add(fmt::format("material '{}' is missing: its surfaces are matt grey", part.material));
    return -1;
  }

  int node(const std::string& name, int parent) {
    const auto [at, fresh] = nodes_.try_emplace({parent, name}, int(scene_.nodes.size()));
    if (fresh) {
      Node n;
      n.name = name, n.parent = parent;
      scene_.nodes.push_back(std::move(n));
    }
    return at->second;
  }
  int node_of(const Part& part) {
    const int object = part.object.empty() ? -1 : node(part.object, -1);
    const bool own = part.group.empty() || part.group == "default" || part.group == part.object;
    return own && (object >= 0 || part.group.empty()) ? object : node(part.group, object);
  }

  const File& file_;
  Scene& scene_;
  const ImportOptions& options_;
  const std::map<std::string, int>& materials_;
  std::map<std::pair<int, std::string>, int> nodes_;
  Triangulator cutter_;
};

std::string leftovers(const File& file) {
  if (file.points + file.lines > 0) return fmt::format("{} points and {} lines only", file.points, file.lines);
  return file.positions.empty() ? "" : fmt::format("{} vertices, but no face", file.positions.size());
}

}  // namespace

Scene read_obj(std::span<const uint8_t> bytes, const Path& folder, const std::string& where,
               const ImportOptions& options) {
  check_memory(12 * uint64_t(bytes.size()), where, options);  // "f 1 2 3" becomes a face and three vertices
  const File file = obj::parse(decode_text(bytes), where);
  Scene scene;
  scene.source = where;
  scene.warnings = file.warnings;
  Beside beside(folder, options);
  std::map<std::string, int> materials;
  read_libraries(file, beside, scene, materials);
  Builder(file, scene, options, materials).run();
  scene.warnings.add("OBJ points are not drawn", file.points);
  scene.warnings.add("OBJ lines are not drawn", file.lines);
  scene.warnings.add("vertices without a colour among others that have one were taken as white", file.colourless);
  finish_scene(scene, options, leftovers(file));
  return scene;
}

}  // namespace aktina
