// OFF -> Scene: OFF, COFF, NOFF, STOFF and their mixtures, in text. Geomview manual, "OFF Files".
#include <fmt/core.h>

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/image/image.h"
#include "aktina/import/beside.h"
#include "aktina/import/mesh_tools.h"
#include "aktina/import/polygon.h"
#include "aktina/import/text.h"

namespace aktina {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& where, Warnings& warnings)
      : lines_(text), size_(text.size()), where_(where), warnings_(warnings) {}

  Mesh run() {
    keyword();
    const uint64_t vertices = count("vertices"), faces = count("faces");
    count("edges");
    if (vertices > size_ / 6 || faces > size_ / 2)  // "0 0 0\n", "1 0\n"
      fail(fmt::format("{} vertices and {} faces are claimed in {} bytes", vertices, faces, size_));
    for (uint64_t i = 0; i < vertices; ++i) vertex();
    for (uint64_t i = 0; i < faces; ++i) face();
    warnings_.add("faces with vertex indices out of range were dropped", beyond_);
    warnings_.add("faces with fewer than three corners were dropped", small_);
    warnings_.add("polygons that cross themselves were cut into fans", cutter_.given_up());
    return std::move(mesh_);
  }

  uint64_t vertex_count() const { return mesh_.positions.size(); }

 private:
  /// [ST][C][N]OFF; the numbers may follow on the same line.
  void keyword() {
    std::string_view word = this->word();
    const std::string_view whole = word;
    const auto skip = [&](std::string_view prefix) {
      if (!word.starts_with(prefix) || word.size() <= prefix.size()) return false;
      word.remove_prefix(prefix.size());
      return true;
    };
    texture_ = skip("ST"), colour_ = skip("C"), normal_ = skip("N");
    if (word != "OFF") {
      if (word == "4OFF" || word == "nOFF" || word == "4nOFF")
        throw Error(Code::unsupported, where_, fmt::format("'{}' has other than three dimensions", whole));
      fail("does not begin with OFF");
    }
    std::string_view ahead = line_;
    if (next_word(ahead) == "BINARY") throw Error(Code::unsupported, where_, "binary OFF is not read");
  }

  std::string_view word() {
    std::string_view word = next_word(line_);
    while (word.empty()) {
      if (!lines_.next(line_)) fail("the file ends too early");
      line_ = line_.substr(0, line_.find('#'));
      word = next_word(line_);
    }
    return word;
  }
  float number() {
    const std::string_view text = word();
    float value = 0;
    if (!parse_number(text, value)) fail(fmt::format("'{}' is no number", text.substr(0, 40)));
    return value;
  }
  uint64_t count(const char* what) {
    const std::string_view text = word();
    int64_t value = 0;
    if (!parse_number(text, value) || value < 0) fail(fmt::format("'{}' is no number of {}", text.substr(0, 40), what));
    return uint64_t(value);
  }

  void vertex() {
    const auto vector = [&] {
      const float x = number(), y = number(), z = number();
      return Vec3(x, y, z);
    };
    mesh_.positions.push_back(vector());
    if (normal_) mesh_.normals.push_back(vector());
    if (colour_) {  // 0 .. 255 or 0 .. 1: whole numbers say the first
      Vec4 c(vector(), 1);
      for (std::string_view rest = line_; !next_word(rest).empty() && !texture_; rest = {}) c.w = number();
      const float scale = std::fmax(std::fmax(c.x, c.y), c.z) > 1 ? 1 / 255.0f : 1;
      mesh_.colours.emplace_back(srgb_to_linear(c.x * scale), srgb_to_linear(c.y * scale), srgb_to_linear(c.z * scale),
                                 c.w > 1 ? c.w / 255 : c.w);
    }
    if (texture_) {
      const float u = number(), v = number();
      mesh_.uv[0].emplace_back(u, 1 - v);
    }
  }

  /// What follows the indices on the line, a colour of the face, is left out.
  void face() {
    const uint64_t corners = count("corners");
    if (corners > size_) fail(fmt::format("a face claims {} corners", corners));
    indices_.clear(), outline_.clear();
    bool beyond = false;
    for (uint64_t i = 0; i < corners; ++i) {
      const uint64_t index = count("a vertex");
      beyond = beyond || index >= mesh_.positions.size();
      if (beyond) continue;
      indices_.push_back(uint32_t(index));
      outline_.push_back(mesh_.positions[index]);
    }
    if (!next_word(line_).empty()) warnings_.add("colours of OFF faces were left out");
    line_ = {};
    if (beyond) return void(++beyond_);
    if (corners < 3) return void(++small_);
    for (const auto& t : cutter_.triangulate(outline_)) {
      mesh_.triangles.push_back({indices_[t[0]], indices_[t[1]], indices_[t[2]]});
      mesh_.triangle_face.push_back(mesh_.face_count);
    }
    ++mesh_.face_count;
  }

  [[noreturn]] void fail(std::string what) const {
    throw Error(Code::bad_input, place(where_, lines_.number()), std::move(what));
  }

  Lines lines_;
  std::string_view line_;
  uint64_t size_;
  const std::string& where_;
  Warnings& warnings_;
  Mesh mesh_;
  bool texture_ = false, colour_ = false, normal_ = false;
  Triangulator cutter_;
  std::vector<uint32_t> indices_;
  std::vector<Point3> outline_;
  uint64_t beyond_ = 0, small_ = 0;
};

}  // namespace

Scene read_off(std::span<const uint8_t> bytes, const std::string& where, const ImportOptions& options) {
  check_memory(20 * uint64_t(bytes.size()), where, options);
  Scene scene;
  scene.source = where;
  add_mesh(scene, OffReader(decode_text(bytes), where, scene.warnings).run(), options);
  finish_scene(scene, options, "no faces");
  return scene;
}

}  // namespace aktina
