// JSON text -> document. The parser builds the document without recursion, but what walks it later recurses, so depth
// is bounded first; so is the number of values, each of which takes about a hundred bytes.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "aktina/base/error.h"
#include "aktina/import/gltf/container.h"

namespace aktina::gltf {
namespace {

constexpr size_t kDeepest = 200;
constexpr size_t kMostValues = size_t(1) << 25;

/// Counts brackets and commas outside of texts.
void check_shape(std::span<const uint8_t> text, const std::string& where) {
  size_t depth = 0, values = 0;
  bool quoted = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const uint8_t c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
      continue;
    }
    if (c == '"') quoted = true;
    if (c == '{' || c == '[' || c == ',') ++values;
    if (c == '{' || c == '[') ++depth;
    if ((c == '}' || c == ']') && depth > 0) --depth;
    if (depth > kDeepest)
      throw Error(Code::bad_input, fmt::format("{} byte {}", where, i),
                  fmt::format("JSON is nested deeper than {}", kDeepest));
  }
  if (values > kMostValues) throw Error(Code::limit, where, fmt::format("more than {} JSON values", kMostValues));
}

}  // namespace

void DeleteJson::operator()(Json* json) const { delete json; }

JsonPointer parse_json(std::span<const uint8_t> text, const std::string& where) {
  if (text.empty()) throw Error(Code::bad_input, where, "the file is empty");
  check_shape(text, where);
  try {
    JsonPointer root(new Json(Json::parse(text.begin(), text.end())));
    if (!root->is_object()) throw Error(Code::bad_input, where, "glTF's JSON should be an object");
    return root;
  } catch (const Json::exception& error) {
    const std::string_view message = error.what();
    const size_t end_of_id = message.find("] ");  // of "[json.exception.parse_error.101] "
    throw Error(Code::bad_input, where, std::string(message.substr(end_of_id == message.npos ? 0 : end_of_id + 2)));
  }
}

}  // namespace aktina::gltf
