// STL -> Scene, ASCII and binary; each solid a mesh. 3D Systems, "StereoLithography Interface Specification", 1988.
#include <fmt/core.h>

#include <cstring>

#include "aktina/base/error.h"
#include "aktina/import/beside.h"
#include "aktina/import/mesh_tools.h"
#include "aktina/import/text.h"
#include "aktina/scene/weld.h"

namespace aktina {
namespace {

constexpr size_t kHeader = 84, kFacet = 50;  // bytes

uint32_t claimed_facets(std::span<const uint8_t> bytes) {
  return bytes[80] | uint32_t(bytes[81]) << 8 | uint32_t(bytes[82]) << 16 | uint32_t(bytes[83]) << 24;
}

/// "solid" opens binary files as well: the length decides, then whether there is a facet in words.
bool is_text(std::span<const uint8_t> bytes) {
  if (bytes.size() >= kHeader && bytes.size() == kHeader + uint64_t(claimed_facets(bytes)) * kFacet) return false;
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), std::min<size_t>(bytes.size(), 4096));
  return lower_case(trimmed(text).substr(0, 5)) == "solid" && text.find('\0') == text.npos;
}

void add_facet(Mesh& mesh, const Point3 corners[3]) {
  const auto first = uint32_t(mesh.positions.size());
  for (int k = 0; k < 3; ++k) mesh.positions.push_back(corners[k]);
  mesh.triangles.push_back({first, first + 1, first + 2});
}

/// Facets share no vertices in the file. Their normals are computed: those in files are often zero or wrong.
void add_solid(Scene& scene, Mesh mesh, const ImportOptions& options) {
  const std::vector<uint32_t> first = weld(mesh.positions);
  for (auto& t : mesh.triangles) t = {first[t[0]], first[t[1]], first[t[2]]};
  add_mesh(scene, std::move(mesh), options);
}

Mesh read_binary(std::span<const uint8_t> bytes, const std::string& where, Warnings& warnings) {
  if (bytes.size() < kHeader) throw Error(Code::bad_input, where, "is neither an ASCII nor a binary STL file");
  const uint64_t claimed = claimed_facets(bytes), there = (bytes.size() - kHeader) / kFacet;
  if (claimed > there)
    throw Error(Code::bad_input, fmt::format("{}: byte 80", where),
                fmt::format("{} facets are claimed, but only {} are there", claimed, there));
  if (bytes.size() > kHeader + claimed * kFacet) warnings.add("bytes after the last facet were left out");
  Mesh mesh;
  for (uint64_t i = 0; i < claimed; ++i) {
    Point3 corners[3];
    static_assert(sizeof(corners) == 36);
    std::memcpy(corners, bytes.data() + kHeader + i * kFacet + 12, 36);
    add_facet(mesh, corners);
  }
  return mesh;
}

class TextStl {
 public:
  TextStl(std::string_view text, const std::string& where, Scene& scene, const ImportOptions& options)
      : lines_(text), where_(where), scene_(scene), options_(options) {}

  void run() {
    std::string_view line;
    while (lines_.next(line)) {
      const std::string keyword = lower_case(next_word(line));
      if (keyword == "solid")
        mesh_.name = utf8_or_latin1(trimmed(line));
      else if (keyword == "vertex")
        vertex(line);
      else if (keyword == "endloop" || keyword == "endfacet")
        end_facet();
      else if (keyword == "endsolid")
        end_solid();
      else if (!keyword.empty() && keyword != "facet" && keyword != "outer" && keyword != "color")
        fail(fmt::format("'{}' is no statement of STL", keyword.substr(0, 40)));
    }
    if (!mesh_.triangles.empty() || count_ > 0) {
      scene_.warnings.add("the file ends before its last solid does");
      count_ = 0;
      end_solid();
    }
  }

 private:
  void vertex(std::string_view rest) {
    Point3 p;
    for (int k = 0; k < 3; ++k)
      if (!parse_number(next_word(rest), p[k])) fail("vertex does not have three numbers");
    if (count_ == 3) fail("facet has more than three vertices");
    corners_[count_++] = p;
  }
  void end_facet() {
    if (count_ == 0) return;
    if (count_ != 3) fail(fmt::format("facet has {} of 3 vertices", count_));
    add_facet(mesh_, corners_);
    count_ = 0;
  }
  void end_solid() {
    end_facet();
    add_solid(scene_, std::move(mesh_), options_);
    mesh_ = {};
  }
  [[noreturn]] void fail(std::string what) const {
    throw Error(Code::bad_input, place(where_, lines_.number()), std::move(what));
  }

  Lines lines_;
  const std::string& where_;
  Scene& scene_;
  const ImportOptions& options_;
  Mesh mesh_;
  Point3 corners_[3];
  size_t count_ = 0;
};

}  // namespace

Scene read_stl(std::span<const uint8_t> bytes, const std::string& where, const ImportOptions& options) {
  check_memory(6 * uint64_t(bytes.size()), where, options);
  Scene scene;
  scene.source = where;
  if (is_text(bytes))
    TextStl({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, where, scene, options).run();
  else
    add_solid(scene, read_binary(bytes, where, scene.warnings), options);
  finish_scene(scene, options, "no facets");
  return scene;
}

}  // namespace aktina
