#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "aktina/base/error.h"
#include "aktina/import/text.h"
#include "aktina/import/vs3/vs3.h"

namespace aktina {
namespace {

class Reader {
 public:
  Reader(std::string_view text, const std::string& where) : lines_(text), where_(where) {}

  Vs3 run() {
    std::string_view line;
    while (!ended_ && lines_.next(line)) {
      std::string_view rest = line.substr(0, line.find_first_of("!/"));
      const std::string_view word = next_word(rest);
      if (!word.empty()) element(word, rest);
    }
    check_references();
    return std::move(result_);
  }

 private:
  void element(std::string_view word, std::string_view rest) {
    switch (word[0] | 0x20) {
      case 't':
        result_.title = utf8_or_latin1(trimmed(rest));
        break;
      case 'f':
        geometry(rest);
        break;
      case 'v':
        vertex(rest);
        break;
      case 's':
        surface(Vs3::Kind::surface, rest);
        break;
      case 'n':
        surface(Vs3::Kind::null, rest);
        break;
      case 'o':
        surface(Vs3::Kind::obstruction, rest);
        break;
      case 'm':
        throw Error(Code::unsupported, place(where_, lines_.number()), "masking surfaces are not read");
      case 'c':
        break;  // the accuracy is the caller's
      case 'e':
      case '*' | 0x20:
        ended_ = true;
        break;
      default:
        fail(fmt::format("'{}' begins no line of a .vs3 file", word.substr(0, 20)));
    }
  }

  void geometry(std::string_view rest) {
    const std::string_view format = next_word(rest);
    if (format != "3")
      throw Error(Code::unsupported, place(where_, lines_.number()), fmt::format("geometry F {}", format.substr(0, 20)),
                  "only F 3 is read");
  }

  int64_t whole(std::string_view& rest) {
    const std::string_view word = next_word(rest);
    int64_t value = 0;
    if (!parse_number(word, value) || value < 0) fail(fmt::format("'{}' is no number", word.substr(0, 20)));
    return value;
  }
  double number(std::string_view& rest) {
    const std::string_view word = next_word(rest);
    double value = 0;
    if (!parse_number(word, value) || !std::isfinite(value)) fail(fmt::format("'{}' is no number", word.substr(0, 20)));
    return value;
  }

  void vertex(std::string_view rest) {
    const int64_t id = whole(rest);
    const double x = number(rest), y = number(rest), z = number(rest);
    if (!vertices_.try_emplace(id, x, y, z).second) fail(fmt::format("vertex {} is there twice", id));
  }

  void surface(Vs3::Kind kind, std::string_view rest) {
    Vs3::Surface s;
    s.kind = kind, s.number = whole(rest);
    for (int k = 0; k < 4; ++k) {
      const int64_t id = whole(rest);
      if (id == 0 && k == 3) break;
      const auto at = vertices_.find(id);
      if (at == vertices_.end()) fail(fmt::format("there is no vertex {}", id));
      s.corners.push_back(at->second);
    }
    s.base = whole(rest), s.combine = whole(rest), s.emissivity = number(rest);
    const std::string_view name = next_word(rest);
    s.name = name.empty() ? fmt::format("{}", s.number) : utf8_or_latin1(name);
    if (!numbers_.try_emplace(s.number, result_.surfaces.size()).second)
      fail(fmt::format("surface {} is there twice", s.number));
    result_.surfaces.push_back(std::move(s));
  }

  void check_references() const {
    for (const Vs3::Surface& s : result_.surfaces)
      for (const int64_t other : {s.base, s.combine})
        if (other != 0 && (!numbers_.contains(other) || other == s.number))
          throw Error(Code::bad_input, where_, fmt::format("surface {} refers to surface {}", s.number, other));
    if (result_.surfaces.empty()) throw Error(Code::bad_input, where_, "has no surfaces");
  }

  [[noreturn]] void fail(std::string what) const {
    throw Error(Code::bad_input, place(where_, lines_.number()), std::move(what));
  }

  Lines lines_;
  const std::string& where_;
  Vs3 result_;
  std::unordered_map<int64_t, Point3d> vertices_;
  std::unordered_map<int64_t, size_t> numbers_;
  bool ended_ = false;
};

}  // namespace

Vs3 read_vs3(std::string_view text, const std::string& where) { return Reader(text, where).run(); }

}  // namespace aktina
