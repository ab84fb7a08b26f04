// What a .gltf or .glb file is made of: a JSON document and, in a .glb, a chunk of binary data.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "aktina/base/warnings.h"
#include "aktina/import/gltf/value.h"

namespace aktina::gltf {

struct Container {
  std::span<const uint8_t> json;
  std::span<const uint8_t> binary;
  bool has_binary = false;
};

bool is_glb(std::span<const uint8_t> bytes);

/// @throws Error bad_input (lengths that are lies, missing chunk, version), unsupported (glTF 1)
Container open_container(std::span<const uint8_t> bytes, const std::string& where, Warnings& warnings);

struct DeleteJson {
  void operator()(Json* json) const;
};
using JsonPointer = std::unique_ptr<Json, DeleteJson>;

/// @throws Error bad_input (syntax, encoding, too deep, no object), limit (too many values)
JsonPointer parse_json(std::span<const uint8_t> text, const std::string& where);

}  // namespace aktina::gltf
