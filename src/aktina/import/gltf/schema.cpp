#include "aktina/import/gltf/schema.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "aktina/base/error.h"

namespace aktina::gltf {
namespace {

using Kind = Property::Kind;

class SchemaChecker {
 public:
  SchemaChecker(Json& root, const std::string& where, Warnings& warnings)
      : root_(root), where_(where), warnings_(warnings) {}

  void run() {
    const auto used = root_.find("extensionsUsed");
    if (used != root_.end() && used->is_array())
      for (const Json& name : *used)
        if (name.is_string()) declared_.insert(name.get<std::string>());
    check_object(root_, kRootShape);
  }

 private:
  /// Adds a step to the path of the place in hand while it lives.
  struct Step {
    Step(std::string& path, std::string_view name) : path_(path), length_(path.size()) {
      path_.append("/").append(name);
    }
    ~Step() { path_.resize(length_); }
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;
    std::string& path_;
    size_t length_;
  };

  /// The path with numbers left open, so that a fault that a file repeats is counted and not listed.
  std::string pattern() const {
    std::string out;
    for (size_t i = 0; i < path_.size(); ++i) {
      const bool starts = path_[i] >= '0' && path_[i] <= '9' && path_[i - 1] == '/';
      size_t end = i;
      while (starts && end < path_.size() && path_[end] >= '0' && path_[end] <= '9') ++end;
      const bool index = starts && (end == path_.size() || path_[end] == '/');
      out += index ? '*' : path_[i];
      if (index) i = end - 1;
    }
    return out;
  }
  void warn(std::string_view what) { warnings_.add(pattern() + ": " + std::string(what)); }

  /// What cannot be understood: an error in what Aktina reads, else a part to leave out.
  bool fault(const std::string& what) {
    if (unread_ == 0) throw Error(Code::bad_input, path_.empty() ? where_ : where_ + " " + path_, what);
    warn(what + " (not used)");
    return false;
  }

  void check_object(Json& object, const Shape& shape) {
    unread_ += shape.read ? 0 : 1;
    for (const Property& property : shape.properties) {
      const auto member = object.find(property.name);
      const Step step(path_, property.name);
      if (member == object.end()) {
        if (property.required) fault("is missing");
      } else if (!check(*member, property)) {
        object.erase(member);
      }
    }
    check_extensions_of(object, shape);
    unread_ -= shape.read ? 0 : 1;
  }

  void check_extensions_of(Json& object, const Shape& shape) {
    const auto extensions = object.find("extensions");
    if (extensions == object.end()) return;
    const Step step(path_, "extensions");
    if (!extensions->is_object()) {
      fault("should be an object");
      object.erase(extensions);
      return;
    }
    for (auto& [name, value] : extensions->items()) check_extension(name, value, shape);
  }

  void check_extension(const std::string& name, Json& value, const Shape& owner) {
    bool known = false;
    for (const ExtensionShape& extension : extension_shapes()) {
      if (extension.name != name) continue;
      known = true;
      if (extension.owner != owner.name) continue;
      const Step step(path_, name);
      if (!declared_.contains(name)) warn("extensionsUsed does not name this extension");
      if (!value.is_object()) fault("should be an object");
      if (extension.shape && value.is_object()) check_object(value, *extension.shape);
      return;
    }
    const Step step(path_, known ? std::string_view(name) : "*");
    if (known) warn("this extension has no meaning here and was ignored");
    if (!known && !declared_.contains(name)) warn("an extension that extensionsUsed does not name was ignored");
  }

  /// @return whether the member may stay
  bool check(Json& value, const Property& p) {
    switch (p.kind) {
      case Kind::flag:
        return value.is_boolean() || fault("should be true or false");
      case Kind::text:
        return value.is_string() || fault("should be a text");
      case Kind::whole:
        return check_whole(value, p);
      case Kind::number:
        return check_number(value, p);
      case Kind::numbers:
        return check_numbers(value, p);
      case Kind::reference:
        return check_reference(value, p);
      case Kind::references:
        return check_references(value, p);
      case Kind::map:
        return check_map(value, p);
      case Kind::extension:
      case Kind::object:
        return check_one(value, p);
      case Kind::objects:
      case Kind::maps:
        return check_list(value, p);
    }
    return true;
  }

  static bool is_whole(const Json& value) {
    if (value.is_number_unsigned()) return true;
    if (!value.is_number_float()) return false;
    const double number = value.get<double>();
    return number >= 0 && number <= 9007199254740992.0 && number == std::floor(number);
  }

  bool check_whole(Json& value, const Property& p) {
    if (!is_whole(value)) return fault("should be a whole number from 0");
    const double number = value.get<double>();
    if (number >= p.low && number <= p.high) return true;
    if (p.name == "mode") return fault(fmt::format("{} is out of range ({} to {})", number, p.low, p.high));
    warn("is out of range");  // lengths and strides are checked again where they are used
    return true;
  }

  bool check_number(Json& value, const Property& p) {
    if (!value.is_number()) return fault("should be a number");
    const double number = value.get<double>();
    if (number >= p.low && number <= p.high) return true;
    warn("numbers out of range were brought into it");
    value = number < p.low ? p.low : p.high;
    return true;
  }

  bool check_numbers(Json& value, const Property& p) {
    if (!value.is_array()) return fault("should be an array of numbers");
    if (value.size() < p.least || value.size() > p.most)
      return fault(fmt::format("should be {} numbers, not {}", p.least, value.size()));
    const Property element{p.name, Kind::number, p.low, p.high};
    for (size_t i = 0; i < value.size(); ++i) {
      const Step step(path_, std::to_string(i));
      if (!check_number(value[i], element)) return false;
    }
    return true;
  }

  size_t size_of(std::string_view list) const {
    const Json::json_pointer pointer{std::string(list)};
    return root_.contains(pointer) && root_[pointer].is_array() ? root_[pointer].size() : 0;
  }

  bool check_reference(Json& value, const Property& p) {
    if (!is_whole(value)) return fault("should be a whole number from 0");
    const double index = value.get<double>();
    const size_t size = size_of(p.list);
    if (index < double(size)) return true;
    return fault(fmt::format("refers to number {} of {}, which has {}", index, p.list, size));
  }

  bool check_references(Json& value, const Property& p) {
    if (!value.is_array()) return fault("should be an array");
    if (value.empty()) return remove_empty();
    for (size_t i = 0; i < value.size(); ++i) {
      const Step step(path_, std::to_string(i));
      if (!check_reference(value[i], p)) return false;
    }
    return true;
  }

  bool check_map(Json& value, const Property& p) {
    if (!value.is_object()) return fault("should be an object");
    if (value.empty()) warn("is empty");
    for (auto& [name, index] : value.items()) {
      const Step step(path_, unread_ ? "*" : name);
      if (!check_reference(index, p)) return false;
    }
    return true;
  }

  bool check_one(Json& value, const Property& p) {
    if (!value.is_object()) return fault("should be an object");
    if (p.shape) check_object(value, *p.shape);
    return true;
  }

  bool check_list(Json& value, const Property& p) {
    if (!value.is_array()) return fault("should be an array");
    if (value.empty()) return remove_empty();
    for (size_t i = 0; i < value.size(); ++i) {
      const Step step(path_, std::to_string(i));
      if (!(p.kind == Kind::maps ? check_map(value[i], p) : check_one(value[i], p))) return false;
    }
    return true;
  }

  bool remove_empty() {
    warn("is an empty list, which should be left out");
    return false;
  }

  Json& root_;
  const std::string& where_;
  Warnings& warnings_;
  std::string path_;
  std::set<std::string> declared_;
  int unread_ = 0;  // shapes around the place in hand that Aktina does not read
};

}  // namespace

void check_schema(Json& root, const std::string& where, Warnings& warnings) {
  SchemaChecker(root, where, warnings).run();
}

}  // namespace aktina::gltf
