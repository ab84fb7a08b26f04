#include "aktina/import/gltf/value.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace aktina::gltf {
namespace {

constexpr double kLargestWhole = 9007199254740992.0;  // 2^53: beyond it numbers of JSON are no longer exact

std::string escaped(const std::string& key) {
  std::string out;
  for (const char c : key) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return out;
}

/// Path from `from` to the very object `target`; a place is looked for only once something is wrong there. The depth of
/// a document is bounded when it is parsed.
bool find(const Json& from, const Json* target, std::string& path) {
  if (&from == target) return true;
  const size_t length = path.size();
  if (from.is_object()) {
    for (const auto& [key, child] : from.items()) {
      path += "/" + escaped(key);
      if (find(child, target, path)) return true;
      path.resize(length);
    }
  } else if (from.is_array()) {
    for (size_t i = 0; i < from.size(); ++i) {
      path += "/" + std::to_string(i);
      if (find(from[i], target, path)) return true;
      path.resize(length);
    }
  }
  return false;
}

}  // namespace

Value Value::operator[](const char* key) const {
  Value out = *this;
  if (!json_) return out;
  if (!json_->is_object()) expected("an object");
  const auto found = json_->find(key);
  out.json_ = found == json_->end() ? nullptr : &*found;
  if (!out.json_) out.parent_ = json_, out.key_ = key;
  return out;
}

Value Value::operator[](size_t index) const {
  Value out = *this;
  if (!json_) return out;
  if (!json_->is_array()) expected("an array");
  if (index >= json_->size()) fail(fmt::format("has no element {}", index));
  out.json_ = &(*json_)[index];
  return out;
}

Value Value::aktina_extras() const {
  Value extras = (*this)["extras"];
  if (extras.json_ && !extras.json_->is_object()) extras.json_ = nullptr;
  return extras["aktina"];
}

size_t Value::size() const { return json_ && json_->is_structured() ? json_->size() : 0; }

std::vector<std::string> Value::names() const {
  std::vector<std::string> out;
  if (!json_) return out;
  if (!json_->is_object()) expected("an object");
  for (const auto& [key, unused] : json_->items()) out.push_back(key);
  return out;
}

bool Value::is_number() const { return json_ && json_->is_number(); }

double Value::number(double fallback) const {
  if (!json_) return fallback;
  if (!json_->is_number()) expected("a number");
  const auto value = json_->get<double>();
  if (!(std::abs(value) <= double(std::numeric_limits<float>::max())) && !json_->is_number_integer())
    fail("is too large a number");
  return value;
}

uint64_t Value::whole(uint64_t fallback) const {
  if (!json_) return fallback;
  if (json_->is_number_unsigned()) return json_->get<uint64_t>();
  const double value = json_->is_number_float() ? json_->get<double>() : -1;
  if (!(value >= 0) || value > kLargestWhole || value != std::floor(value)) expected("a whole number from 0");
  return uint64_t(value);
}

bool Value::flag(bool fallback) const {
  if (!json_) return fallback;
  if (!json_->is_boolean()) expected("true or false");
  return json_->get<bool>();
}

std::string_view Value::text_view() const {
  if (!json_) return {};
  if (!json_->is_string()) expected("a text");
  return json_->get_ref<const std::string&>();
}

std::string Value::text(const std::string& fallback) const { return json_ ? std::string(text_view()) : fallback; }

int Value::index(size_t size) const {
  if (!json_) return -1;
  const uint64_t index = whole(0);
  if (index >= size) fail(fmt::format("refers to number {}, but there are {}", index, size));
  return int(index);
}

bool Value::numbers(std::span<float> out) const {
  if (!json_) return false;
  if (!json_->is_array() || json_->size() != out.size()) fail(fmt::format("should be {} numbers", out.size()));
  for (size_t i = 0; i < out.size(); ++i) out[i] = (*this)[i].real(0);
  return true;
}

Rgb Value::rgb(Rgb fallback) const {
  float v[] = {fallback.r, fallback.g, fallback.b};
  numbers(v);
  return {v[0], v[1], v[2]};
}

Vec2 Value::vec2(Vec2 fallback) const {
  float v[] = {fallback.x, fallback.y};
  numbers(v);
  return {v[0], v[1]};
}

std::string Value::pointer() const {
  std::string path;
  const Json* target = json_ ? json_ : parent_;
  if (target) find(*source_->root, target, path);
  return json_ || !key_ ? path : path + "/" + escaped(key_);
}

std::string Value::place() const {
  const std::string path = pointer();
  return path.empty() ? source_->where : source_->where + " " + path;
}

std::string Value::json() const { return json_ ? json_->dump(-1, ' ', false, Json::error_handler_t::replace) : ""; }

void Value::fail(const std::string& what, Code code, const std::string& hint) const {
  throw Error(code, place(), what, hint);
}

void Value::expected(const char* what) const { fail(fmt::format("should be {}, not {}", what, json_->type_name())); }

}  // namespace aktina::gltf
