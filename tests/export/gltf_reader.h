// Reads back what the glTF writer wrote, by the specification alone.
#pragma once

#include <cstring>
#include <nlohmann/json.hpp>

#include "aktina/base/file.h"

namespace aktina::test {

struct GltfFile {
  nlohmann::json json;
  std::vector<uint8_t> data;

  explicit GltfFile(const Path& path) {
    const std::vector<uint8_t> bytes = read_file(path);
    if (lower_extension(path) == "gltf") {
      json = nlohmann::json::parse(bytes);
      if (json.contains("buffers")) data = read_file(path.parent_path() / json["buffers"][0]["uri"].get<std::string>());
      return;
    }
    const auto word = [&](size_t at) {
      uint32_t value = 0;
      std::memcpy(&value, bytes.data() + at, 4);
      return value;
    };
    if (word(0) != 0x46546C67 || word(4) != 2 || word(8) != bytes.size()) throw std::runtime_error("no .glb header");
    const size_t length = word(12);
    json = nlohmann::json::parse(bytes.begin() + 20, bytes.begin() + 20 + long(length));
    if (20 + length < bytes.size()) data.assign(bytes.begin() + 28 + long(length), bytes.end());
  }

  /// Numbers of an accessor of floats or of indices.
  std::vector<double> values(int accessor) const {
    const auto& a = json["accessors"][size_t(accessor)];
    const auto& view = json["bufferViews"][a["bufferView"].get<size_t>()];
    const size_t count = a["count"].get<size_t>() * (a["type"] == "SCALAR" ? 1
                                                     : a["type"] == "VEC2" ? 2
                                                     : a["type"] == "VEC3" ? 3
                                                                           : 4);
    const int type = a["componentType"];
    std::vector<double> out;
    const uint8_t* at = data.data() + view["byteOffset"].get<size_t>();
    for (size_t i = 0; i < count; ++i) {
      if (type == 5126) out.push_back(double(read<float>(at)));
      if (type == 5125) out.push_back(read<uint32_t>(at));
      if (type == 5123) out.push_back(read<uint16_t>(at));
      at += type == 5123 ? 2 : 4;
    }
    return out;
  }

 private:
  template <class T>
  static T read(const uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
  }
};

}  // namespace aktina::test
