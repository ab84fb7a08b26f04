#include "aktina/export/gltf_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "aktina/base/error.h"

namespace aktina::gltf_export {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little endian");

constexpr int kFloat = 5126, kShort = 5123, kInt = 5125, kArray = 34962, kElements = 34963;
constexpr size_t kMostBytes = 0xffffffffu - 4096;  // a .glb states its length in 32 bits

std::span<const uint8_t> bytes_of(const auto& values) {
  return {reinterpret_cast<const uint8_t*>(values.data()), values.size() * sizeof(values[0])};
}

/// Relative reference to a file beside this one: RFC 3986's unreserved characters stay, others are escaped.
std::string uri_of(const Path& path) {
  std::string uri;
  for (const unsigned char c : display(path.filename())) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    uri += plain || std::strchr("-._~", c) ? std::string(1, char(c)) : fmt::format("%{:02X}", c);
  }
  return uri;
}

void append_word(std::vector<uint8_t>& out, uint32_t word) {
  const auto* bytes = reinterpret_cast<const uint8_t*>(&word);
  out.insert(out.end(), bytes, bytes + 4);
}

void append_chunk(std::vector<uint8_t>& out, std::string_view kind, std::span<const uint8_t> bytes, uint8_t padding) {
  const size_t padded = (bytes.size() + 3) & ~size_t(3);
  append_word(out, uint32_t(padded));
  out.insert(out.end(), kind.begin(), kind.end());
  out.insert(out.end(), bytes.begin(), bytes.end());
  out.resize(out.size() + padded - bytes.size(), padding);
}

}  // namespace

int GltfFile::add(std::string_view list, Json item) {
  Json& items = json[std::string(list)];
  items.push_back(std::move(item));
  return int(items.size()) - 1;
}

void GltfFile::use(std::string_view extension) {
  Json& used = json["extensionsUsed"];
  if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
}

int GltfFile::view(std::span<const uint8_t> bytes, int target) {
  data_.resize((data_.size() + 3) & ~size_t(3));
  if (bytes.size() > kMostBytes - std::min(data_.size(), kMostBytes))
    throw Error(Code::limit, "glTF", "its buffer would exceed 4 GiB", "take larger patches");
  Json view = {{"buffer", 0}, {"byteOffset", data_.size()}, {"byteLength", bytes.size()}};
  if (target) view["target"] = target;
  data_.insert(data_.end(), bytes.begin(), bytes.end());
  return add("bufferViews", std::move(view));
}

int GltfFile::attribute(const float* values, size_t count, int components, size_t stride, bool bounds) {
  std::vector<float> packed;
  packed.reserve(count * size_t(components));
  for (size_t i = 0; i < count; ++i) packed.insert(packed.end(), values + i * stride, values + i * stride + components);
  Json accessor = {{"bufferView", view(bytes_of(packed), kArray)},
                   {"componentType", kFloat},
                   {"count", count},
                   {"type", fmt::format("VEC{}", components)}};
  if (bounds) {
    std::vector<float> low(packed.begin(), packed.begin() + components), high = low;
    for (size_t i = 0; i < packed.size(); ++i) {
      const size_t c = i % size_t(components);
      low[c] = std::min(low[c], packed[i]), high[c] = std::max(high[c], packed[i]);
    }
    accessor["min"] = low, accessor["max"] = high;
  }
  return add("accessors", std::move(accessor));
}

int GltfFile::indices(std::span<const uint32_t> corners, size_t vertices) {
  const bool small = vertices < 0xffff;
  const std::vector<uint16_t> narrow(corners.begin(), small ? corners.end() : corners.begin());
  return add("accessors", {{"bufferView", view(small ? bytes_of(narrow) : bytes_of(corners), kElements)},
                           {"componentType", small ? kShort : kInt},
                           {"count", corners.size()},
                           {"type", "SCALAR"}});
}

void GltfFile::write(const Path& path) {
  const auto text = [this] { return json.dump(-1, ' ', false, Json::error_handler_t::replace); };
  if (!data_.empty()) json["buffers"] = {{{"byteLength", data_.size()}}};
  if (lower_extension(path) == "gltf") {
    const Path buffer = Path(path).replace_extension("bin");
    if (!data_.empty()) json["buffers"][0]["uri"] = uri_of(buffer);
    write_through(path, [&](const Path& temporary) {  // both files or neither
      write_file(temporary, text());
      if (!data_.empty()) write_file(buffer, data_);
    });
    return;
  }
  std::vector<uint8_t> body;
  const std::string json_text = text();
  append_chunk(body, "JSON", bytes_of(json_text), ' ');
  if (!data_.empty()) append_chunk(body, std::string_view("BIN\0", 4), data_, 0);
  std::vector<uint8_t> file;
  append_word(file, 0x46546C67);  // "glTF"
  append_word(file, 2);
  append_word(file, uint32_t(12 + body.size()));
  file.insert(file.end(), body.begin(), body.end());
  write_file(path, file);
}

}  // namespace aktina::gltf_export
