// A place in a glTF file's JSON: read with checks, its JSON pointer named where something is wrong.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "aktina/base/error.h"
#include "aktina/base/rgb.h"
#include "aktina/base/vec.h"

namespace aktina::gltf {

using Json = nlohmann::json;

/// The root of a file and the name that messages give it.
struct Source {
  const Json* root = nullptr;
  std::string where;
};

/// Cheap to copy. A member that is not there is an absent value, and so are its members.
class Value {
 public:
  explicit Value(const Source& source) : source_(&source), json_(source.root) {}

  explicit operator bool() const { return json_ != nullptr; }
  Value operator[](const char* key) const;
  Value operator[](size_t index) const;
  Value extension(const char* name) const { return (*this)["extensions"][name]; }
  Value aktina_extras() const;  // extras.aktina; absent where extras are something else than an object

  size_t size() const;                     // of an array or object; 0 of anything else
  std::vector<std::string> names() const;  // of an object's members, sorted
  bool is_number() const;

  // What stands here, or `fallback` where nothing does. Throw Error bad_input for another type.
  double number(double fallback) const;
  float real(float fallback) const { return float(number(double(fallback))); }
  uint64_t whole(uint64_t fallback) const;
  bool flag(bool fallback) const;
  std::string text(const std::string& fallback = {}) const;
  std::string_view text_view() const;  // as long as the document lives
  /// Index into a list of `size`; -1 where nothing stands. Throws where the index is beyond the list.
  int index(size_t size) const;
  /// Fills `out` where an array stands, which must be as long. @return whether one does
  bool numbers(std::span<float> out) const;
  Rgb rgb(Rgb fallback) const;
  Vec2 vec2(Vec2 fallback) const;

  std::string pointer() const;  // RFC 6901, as "/accessors/3/count"
  std::string place() const;    // "room.gltf /accessors/3/count"
  std::string json() const;     // the text of it, without white space
  [[noreturn]] void fail(const std::string& what, Code code = Code::bad_input, const std::string& hint = {}) const;

 private:
  Value member(const Json* found, const char* key) const;
  [[noreturn]] void expected(const char* what) const;

  const Source* source_;
  const Json* json_;
  const Json* parent_ = nullptr;  // of an absent value, the last place that is there
  const char* key_ = nullptr;     // of an absent value, the member looked for there
};

}  // namespace aktina::gltf
