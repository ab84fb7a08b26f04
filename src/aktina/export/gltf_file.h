// A glTF 2.0 file in the making: JSON, and the one binary buffer that it refers to. Knows nothing of scenes.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "aktina/base/file.h"

namespace aktina::gltf_export {

using Json = nlohmann::ordered_json;

class GltfFile {
 public:
  Json json;

  /// Appends to json[list]; returns the index.
  int add(std::string_view list, Json item);
  /// Adds to extensionsUsed.
  void use(std::string_view extension);

  /// Bytes as a bufferView. @throws Error limit: a buffer holds 4 GiB at most
  int view(std::span<const uint8_t> bytes, int target = 0);

  /// Vertex attribute of N components from `count` rows that begin `stride` floats apart.
  int attribute(const float* values, size_t count, int components, size_t stride, bool bounds = false);
  /// Triangle corners, 16 bit where that is enough.
  int indices(std::span<const uint32_t> corners, size_t vertices);

  /// .glb, or .gltf with its buffer beside it in a .bin of the same name. @throws Error io
  void write(const Path& path);

 private:
  std::vector<uint8_t> data_;
};

}  // namespace aktina::gltf_export
