// The statements of an OBJ file. Wavefront Technologies, "Advanced Visualizer Manual", appendix B1, 1995.
#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/image/image.h"
#include "aktina/import/obj/obj.h"
#include "aktina/import/text.h"

namespace aktina::obj {
namespace {

class Parser {
 public:
  Parser(std::string_view text, const std::string& where) : lines_(text), where_(where) {}

  File run() {
    std::string_view line;
    std::string joined;
    while (lines_.next(line)) {
      line_number_ = lines_.number();
      if (line.ends_with('\\')) {  // goes on in the next line
        joined.clear();
        do {
          joined.append(line.substr(0, line.ends_with('\\') ? line.size() - 1 : line.size())) += ' ';
        } while (line.ends_with('\\') && lines_.next(line));
        line = joined;
      }
      statement(line.substr(0, line.find('#')), line);
    }
    if (!file_.colours.empty()) file_.colours.resize(file_.positions.size(), Vec4(1));
    return std::move(file_);
  }

 private:
  void statement(std::string_view rest, std::string_view whole) {
    const std::string_view keyword = next_word(rest);
    if (keyword.empty()) return;
    if (keyword == "v") return vertex(rest);
    if (keyword == "vt") return file_.uvs.push_back(texture_coordinates(rest));
    if (keyword == "vn") return file_.normals.push_back(vector(rest, "normal"));
    if (keyword == "f" || keyword == "fo") return face(rest);
    if (keyword == "l") return void(++file_.lines);
    if (keyword == "p") return void(++file_.points);
    if (keyword == "o") return name(object_, rest);
    if (keyword == "g") return name(group_, rest);
    if (keyword == "usemtl") return name(material_, after_keyword(whole));
    if (keyword == "s") return smoothing(rest);
    if (keyword == "mtllib") return file_.libraries.push_back(utf8_or_latin1(trimmed(after_keyword(whole))));
    if (keyword == "vp" || keyword == "vw") return;
    file_.warnings.add(fmt::format("OBJ statements '{}' were left out", keyword.substr(0, 24)));
  }

  /// What follows the keyword, with any '#': names of files and materials may hold one.
  static std::string_view after_keyword(std::string_view line) {
    next_word(line);
    return line.substr(0, line.find(" #"));
  }

  void name(std::string& to, std::string_view rest) {
    to = utf8_or_latin1(trimmed(rest));
    part_ = nullptr;
  }
  void smoothing(std::string_view rest) {
    const std::string_view word = next_word(rest);
    if (word == "off" || word == "null" || word.empty())
      smoothing_ = 0;
    else if (!parse_number(word, smoothing_) || smoothing_ < 0)
      smoothing_ = 1;
    part_ = nullptr;
  }

  /// Numbers of a line, at most `most` of them.
  size_t numbers(std::string_view& rest, float* values, size_t most, const char* what) {
    size_t count = 0;
    for (std::string_view word = next_word(rest); !word.empty() && count < most; word = next_word(rest))
      if (!parse_number(word, values[count++]))
        fail(fmt::format("{} has '{}' where a number belongs", what, word.substr(0, 40)));
    return count;
  }
  Vec3 vector(std::string_view rest, const char* what) {
    float v[3];
    if (const size_t count = numbers(rest, v, 3, what); count < 3)
      fail(fmt::format("{} has {} of 3 numbers", what, count));
    return {v[0], v[1], v[2]};
  }
  Vec2 texture_coordinates(std::string_view rest) {
    float v[3] = {0, 0, 0};
    if (numbers(rest, v, 3, "texture coordinate") < 1) fail("texture coordinate has no number");
    return {v[0], 1 - v[1]};
  }

  /// x y z, then perhaps w, or r g b, or w r g b. w weights curves: polygons have no use for it.
  void vertex(std::string_view rest) {
    float v[7];
    const size_t count = numbers(rest, v, 7, "vertex");
    if (count < 3) fail(fmt::format("vertex has {} of 3 numbers", count));
    file_.positions.emplace_back(v[0], v[1], v[2]);
    if (count < 6) {
      if (!file_.colours.empty()) ++file_.colourless, file_.colours.emplace_back(1);
      return;
    }
    if (file_.colours.empty() && file_.positions.size() > 1) {
      file_.colourless += file_.positions.size() - 1;
      file_.colours.assign(file_.positions.size() - 1, Vec4(1));
    }
    const float* c = v + count - 3;
    file_.colours.emplace_back(srgb_to_linear(c[0]), srgb_to_linear(c[1]), srgb_to_linear(c[2]), 1);
  }

  /// Index of a list as the file counts it: from 1, or backwards from the last one read.
  int64_t index(std::string_view word, size_t size) {
    int64_t i = 0;
    if (!parse_number(word, i)) fail(fmt::format("face has '{}' where an index belongs", word.substr(0, 40)));
    return i > 0 ? i - 1 : i < 0 ? int64_t(size) + i : -1;
  }

  /// p, p/t, p//n or p/t/n
  Corner corner(std::string_view word) {
    Corner c{kNone, kNone, kNone};
    int64_t* const fields[] = {&c.position, &c.uv, &c.normal};
    const size_t sizes[] = {file_.positions.size(), file_.uvs.size(), file_.normals.size()};
    for (size_t i = 0; i < 3; ++i) {
      const size_t slash = word.find('/');
      const std::string_view field = word.substr(0, slash);
      if (!field.empty()) *fields[i] = index(field, sizes[i]);
      if (slash == word.npos) break;
      if (i == 2) fail("face has a corner with more than three indices");
      word.remove_prefix(slash + 1);
    }
    if (c.position == kNone) fail("face has a corner without a vertex");
    return c;
  }

  void face(std::string_view rest) {
    corners_.clear();
    bool normals = true;
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
      corners_.push_back(corner(word));
      normals = normals && corners_.back().normal != kNone;
    }
    if (corners_.size() < 3) return file_.warnings.add("faces with fewer than three corners were dropped");
    Part& to = part(normals);
    to.sizes.push_back(uint32_t(corners_.size()));
    to.corners.insert(to.corners.end(), corners_.begin(), corners_.end());
  }

  /// The part that faces go to now.
  Part& part(bool normals) {
    if (part_ && part_->has_normals == normals) return *part_;
    const std::string key = fmt::format("{}\n{}\n{}\n{}\n{}", object_, group_, material_, smoothing_, normals);
    const auto [at, fresh] = known_.try_emplace(key, file_.parts.size());
    if (fresh) file_.parts.push_back({object_, group_, material_, smoothing_, normals, {}, {}});
    return *(part_ = &file_.parts[at->second]);
  }

  [[noreturn]] void fail(std::string what) const {
    throw Error(Code::bad_input, place(where_, line_number_), std::move(what));
  }

  Lines lines_;
  const std::string& where_;
  size_t line_number_ = 0;
  File file_;
  std::string object_, group_, material_;
  int64_t smoothing_ = -1;
  Part* part_ = nullptr;
  std::map<std::string, size_t> known_;
  std::vector<Corner> corners_;
};

}  // namespace

File parse(std::string_view text, const std::string& where) { return Parser(text, where).run(); }

}  // namespace aktina::obj
