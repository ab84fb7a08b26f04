// What glTF 2.0 says each object of a file may hold, as a table, and the check of a file against it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "aktina/base/warnings.h"
#include "aktina/import/gltf/value.h"

namespace aktina::gltf {

struct Shape;

struct Property {
  enum class Kind : uint8_t {
    flag,
    whole,   // number without fraction, from low to high
    number,  // from low to high
    text,
    numbers,     // array of `least` to `most` numbers, each from low to high
    object,      // of `shape`
    objects,     // array of such
    reference,   // index into `list`
    references,  // array of such, each once
    map,         // object whose members are references
    maps,        // array of such
    extension,   // object that is not described further
  };
  std::string_view name;
  Kind kind;
  double low = -1e38, high = 1e38;
  size_t least = 1, most = size_t(-1);
  const Shape* shape = nullptr;
  std::string_view list{};  // JSON pointer
  bool required = false;
};

/// `read`: Aktina uses such objects, so what it cannot understand of them is an error; faults of others are warnings.
struct Shape {
  std::string_view name;
  std::span<const Property> properties;
  bool read = true;
};

/// An extension, the shape of the objects that it may stand on, and its own.
struct ExtensionShape {
  std::string_view name, owner;
  const Shape* shape = nullptr;  // null: not described
};

extern const Shape kRootShape;
std::span<const ExtensionShape> extension_shapes();

/// Throws what is not understood; brings numbers into their range, removes empty lists and unusable parts that Aktina
/// does not read, and counts that in `warnings`. Afterwards types and references are as the table says.
/// @throws Error bad_input
void check_schema(Json& root, const std::string& where, Warnings& warnings);

/// Version, required extensions, and extensions that are used but not read.
/// @throws Error unsupported
void check_version(const Value& root, Warnings& warnings);
void check_extensions(const Value& root, Warnings& warnings);

}  // namespace aktina::gltf
