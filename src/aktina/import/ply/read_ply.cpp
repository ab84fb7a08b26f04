// PLY -> Scene: one mesh.
#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/image/image.h"
#include "aktina/import/beside.h"
#include "aktina/import/mesh_tools.h"
#include "aktina/import/ply/header.h"
#include "aktina/import/polygon.h"

namespace aktina {
namespace {

using ply::Element;
using ply::Entry;
using ply::Header;

/// Index of the first property with one of the names; -1: none.
int find(const Element& element, std::initializer_list<std::string_view> names, bool list = false) {
  for (const std::string_view name : names)
    for (size_t i = 0; i < element.properties.size(); ++i)
      if (element.properties[i].name == name && element.properties[i].list == list) return int(i);
  return -1;
}
bool all(std::initializer_list<int> columns) {
  return std::all_of(columns.begin(), columns.end(), [](int c) { return c >= 0; });
}

/// Where an element holds a colour; integers count to their type's largest value, floats to 1 (or to 255 as some have).
struct ColourColumns {
  int r = -1, g = -1, b = -1, a = -1;
  float scale = 1;
  ColourColumns() = default;
  explicit ColourColumns(const Element& e)
      : r(find(e, {"red", "r", "diffuse_red"})),
        g(find(e, {"green", "g", "diffuse_green"})),
        b(find(e, {"blue", "b", "diffuse_blue"})),
        a(find(e, {"alpha", "a", "diffuse_alpha"})) {
    if (!there()) return;
    const ply::Type type = e.properties[size_t(r)].type;
    if (!ply::is_float(type))
      scale = 1 / float(ply::bytes_of(type) == 1 ? 255 : ply::bytes_of(type) == 2 ? 65535 : 255);
  }
  bool there() const { return all({r, g, b}); }
  Vec4 read(const Entry& entry) const {
    const auto value = [&](int column) { return srgb_to_linear(float(entry.values[size_t(column)]) * scale); };
    return {value(r), value(g), value(b), a >= 0 ? float(entry.values[size_t(a)]) * scale : 1};
  }
};

class PlyMesh {
 public:
  PlyMesh(const Header& header, const std::string& where, Warnings& warnings) : warnings_(warnings) {
    for (const Element& element : header.elements) {
      if (element.name == "vertex") vertex_columns(element, where);
      if (element.name == "face") face_columns(element);
      if (element.name == "tristrips") strip_ = find(element, {"vertex_indices", "vertex_index"}, true);
    }
  }

  void add(const Element& element, const Entry& entry) {
    if (element.name == "vertex") add_vertex(element, entry);
    if (element.name == "face" && face_ >= 0) add_face(element, entry);
    if (element.name == "tristrips" && strip_ >= 0) add_strips(entry.lists[size_t(strip_)]);
  }

  Mesh finish() {
    warnings_.add("faces with vertex indices out of range were dropped", beyond_);
    warnings_.add("faces with fewer than three corners were dropped", small_);
    warnings_.add("polygons that cross themselves were cut into fans", cutter_.given_up());
    return face_colour_.there() || corner_uv_ >= 0 ? split() : std::move(mesh_);
  }

 private:
  void vertex_columns(const Element& e, const std::string& where) {
    position_ = {find(e, {"x"}), find(e, {"y"}), find(e, {"z"})};
    normal_ = {find(e, {"nx"}), find(e, {"ny"}), find(e, {"nz"})};
    uv_ = {find(e, {"s", "u", "texture_u", "texture_s"}), find(e, {"t", "v", "texture_v", "texture_t"})};
    colour_ = ColourColumns(e);
    if (!all({position_[0], position_[1], position_[2]}))
      throw Error(Code::bad_input, where, "its vertices have no x, y and z");
  }
  void face_columns(const Element& e) {
    face_ = find(e, {"vertex_indices", "vertex_index"}, true);
    corner_uv_ = find(e, {"texcoord"}, true);
    face_colour_ = ColourColumns(e);
  }

  void add_vertex(const Element& element, const Entry& entry) {
    if (mesh_.positions.empty()) mesh_.positions.reserve(element.count);
    const auto value = [&](int column) { return float(entry.values[size_t(column)]); };
    mesh_.positions.emplace_back(value(position_[0]), value(position_[1]), value(position_[2]));
    if (all({normal_[0], normal_[1], normal_[2]}))
      mesh_.normals.emplace_back(value(normal_[0]), value(normal_[1]), value(normal_[2]));
    if (all({uv_[0], uv_[1]})) mesh_.uv[0].emplace_back(value(uv_[0]), 1 - value(uv_[1]));
    if (colour_.there()) mesh_.colours.push_back(colour_.read(entry));
  }

  bool within(double index) const { return index >= 0 && index < double(mesh_.positions.size()); }

  void add_face(const Element& element, const Entry& entry) {
    if (mesh_.triangles.empty()) mesh_.triangles.reserve(element.count), mesh_.triangle_face.reserve(element.count);
    const std::vector<double>& corners = entry.lists[size_t(face_)];
    if (corners.size() < 3) return void(++small_);
    outline_.clear();
    for (const double index : corners) {
      if (!within(index)) return void(++beyond_);
      outline_.push_back(mesh_.positions[size_t(index)]);
    }
    const uint32_t id = mesh_.face_count++;
    const std::vector<double>* uv = corner_uv_ >= 0 ? &entry.lists[size_t(corner_uv_)] : nullptr;
    for (const auto& t : cutter_.triangulate(outline_)) {
      mesh_.triangles.push_back({uint32_t(corners[t[0]]), uint32_t(corners[t[1]]), uint32_t(corners[t[2]])});
      mesh_.triangle_face.push_back(id);
      for (const uint32_t k : t)
        if (uv) corner_uvs_.push_back(2 * k + 1 < uv->size() ? Vec2((*uv)[2 * k], 1 - (*uv)[2 * k + 1]) : Vec2(0));
    }
    if (face_colour_.there()) face_colours_.push_back(face_colour_.read(entry));
  }

  /// Each index with the two before it; -1 begins anew; every other triangle turns the other way.
  void add_strips(const std::vector<double>& strip) {
    size_t length = 0;
    for (size_t i = 0; i < strip.size(); ++i) {
      if (strip[i] == -1) {
        length = 0;
        continue;
      }
      if (++length < 3) continue;
      if (!within(strip[i]) || !within(strip[i - 1]) || !within(strip[i - 2])) {
        ++beyond_;
        continue;
      }
      const auto a = uint32_t(strip[i - 2]), b = uint32_t(strip[i - 1]), c = uint32_t(strip[i]);
      if (a == b || b == c || c == a) continue;  // stitches between strips
      mesh_.triangles.push_back(length % 2 ? std::array{a, b, c} : std::array{b, a, c});
      mesh_.triangle_face.push_back(mesh_.face_count++);
      if (corner_uv_ >= 0) corner_uvs_.resize(3 * mesh_.triangles.size(), Vec2(0));
      if (face_colour_.there()) face_colours_.resize(mesh_.face_count, Vec4(1));
    }
  }

  /// Attributes of faces: each triangle gets vertices of its own. Normals, where there are none, as if it had not.
  Mesh split() {
    if (mesh_.normals.empty()) generate_normals(mesh_, 0);
    Mesh out;
    for (size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const auto& t = mesh_.triangles[i];
      for (size_t k = 0; k < 3; ++k) {
        out.positions.push_back(mesh_.positions[t[k]]);
        out.normals.push_back(mesh_.normals[t[k]]);
        if (corner_uv_ >= 0)
          out.uv[0].push_back(corner_uvs_[3 * i + k]);
        else if (!mesh_.uv[0].empty())
          out.uv[0].push_back(mesh_.uv[0][t[k]]);
        if (face_colour_.there())
          out.colours.push_back(face_colours_[mesh_.triangle_face[i]]);
        else if (!mesh_.colours.empty())
          out.colours.push_back(mesh_.colours[t[k]]);
      }
      const auto first = uint32_t(3 * i);
      out.triangles.push_back({first, first + 1, first + 2});
    }
    out.triangle_face = std::move(mesh_.triangle_face), out.face_count = mesh_.face_count;
    return out;
  }

  Warnings& warnings_;
  Mesh mesh_;
  Triangulator cutter_;
  std::array<int, 3> position_{-1, -1, -1}, normal_{-1, -1, -1};
  std::array<int, 2> uv_{-1, -1};
  ColourColumns colour_, face_colour_;
  int face_ = -1, strip_ = -1, corner_uv_ = -1;
  std::vector<Point3> outline_;
  std::vector<Vec2> corner_uvs_;    // three a triangle
  std::vector<Vec4> face_colours_;  // one a face
  uint64_t beyond_ = 0, small_ = 0;
};

}  // namespace

Scene read_ply(std::span<const uint8_t> bytes, const std::string& where, const ImportOptions& options) {
  check_memory(40 * uint64_t(bytes.size()), where, options);  // a triangle of 4 bytes becomes a face and three vertices
  const Header header = ply::read_header(bytes, where);
  Scene scene;
  scene.source = where;
  scene.warnings.add("lines of the PLY header that say nothing were left out", header.unknown_lines);
  PlyMesh mesh(header, where, scene.warnings);
  uint64_t vertices = 0;
  ply::read_data(bytes, header, where, [&](const Element& element, const Entry& entry) {
    vertices += element.name == "vertex";
    mesh.add(element, entry);
  });
  add_mesh(scene, mesh.finish(), options);
  finish_scene(scene, options, vertices > 0 ? fmt::format("{} points and no faces", vertices) : "");
  return scene;
}

}  // namespace aktina
