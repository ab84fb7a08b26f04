// Small glTF files made by tests.
#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "aktina/base/error.h"
#include "import/reading.h"

namespace aktina::test {

using Json = nlohmann::json;

/// A scene of one mesh, as a .glb: add accessors, then say what uses them.
class GltfFile {
 public:
  Json json = Json::parse(R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                              "meshes": [{"primitives": [{"attributes": {}}]}], "buffers": [{}], "bufferViews": [],
                              "accessors": []})");

  Json& primitive() { return json["meshes"][0]["primitives"][0]; }

  template <class T>
  int view(const std::vector<T>& values) {
    binary_.resize((binary_.size() + 3) / 4 * 4);
    const size_t offset = binary_.size(), length = values.size() * sizeof(T);
    binary_.resize(offset + length);
    std::memcpy(binary_.data() + offset, values.data(), length);
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}});
    return int(json["bufferViews"].size()) - 1;
  }

  template <class T>
  int accessor(const std::vector<T>& values, const std::string& type, int component, size_t width) {
    json["accessors"].push_back(
        {{"bufferView", view(values)}, {"componentType", component}, {"count", values.size() / width}, {"type", type}});
    return int(json["accessors"].size()) - 1;
  }
  void attribute(const std::string& name, const std::vector<float>& values, size_t width) {
    const char* const kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    primitive()["attributes"][name] = accessor(values, kTypes[width], 5126, width);
  }
  void triangle() { attribute("POSITION", {0, 0, 0, 1, 0, 0, 0, 1, 0}, 3); }

  std::vector<uint8_t> bytes() {
    std::vector<uint8_t> data = binary_;
    data.resize((data.size() + 3) / 4 * 4);
    json["buffers"][0]["byteLength"] = data.size();
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::vector<uint8_t> out;
    const auto word = [&](size_t value) {
      for (int k = 0; k < 4; ++k) out.push_back(uint8_t(value >> (8 * k)));
    };
    word(0x46546C67), word(2), word(28 + text.size() + data.size());
    word(text.size()), word(0x4E4F534A), out.insert(out.end(), text.begin(), text.end());
    word(data.size()), word(0x004E4942), out.insert(out.end(), data.begin(), data.end());
    return out;
  }

  Scene read() {
    ImportOptions options;
    options.default_camera = options.default_light = false;
    return read_gltf(bytes(), "/nowhere", "test.glb", options);
  }

  /// The error's text; empty where there is none.
  std::string fault() {
    try {
      read();
      return {};
    } catch (const Error& error) {
      return error.what();
    }
  }

 private:
  std::vector<uint8_t> binary_;
};

}  // namespace aktina::test
