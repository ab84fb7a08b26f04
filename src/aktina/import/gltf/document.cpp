#include "aktina/import/gltf/document.h"

#include <fmt/format.h>

#include "aktina/import/gltf/meshopt.h"
#include "aktina/import/gltf/schema.h"

namespace aktina::gltf {
namespace {

constexpr uint64_t kFreeAllowance = uint64_t(256) << 20;  // bytes that any file may unfold to
constexpr uint64_t kLargestRatio = 256;                   // and per byte read: more than any codec here compresses

}  // namespace

uint64_t Allowance::left() const {
  const uint64_t most = std::min(most_, kFreeAllowance + kLargestRatio * input_);
  return most > taken_ ? most - taken_ : 0;
}

void Allowance::take(uint64_t bytes, const Value& place) {
  if (bytes > left())
    place.fail(fmt::format("would take {} bytes more, {} are left of what a file of this size may take", bytes, left()),
               Code::limit);
  taken_ += bytes;
}

Document::Document(std::span<const uint8_t> bytes, Path folder_, const std::string& where,
                   const ImportOptions& options_)
    : allowance(options_.most_bytes), options(options_), folder(std::move(folder_)) {
  allowance.add_input(bytes.size());
  container_ = open_container(bytes, where, warnings);
  json_ = parse_json(container_.json, where);
  check_schema(*json_, where, warnings);
  source_ = {json_.get(), where};
  check_version(root(), warnings);
  check_extensions(root(), warnings);
  buffers_.resize(list("buffers").size());
  views_.resize(list("bufferViews").size());
}

std::vector<uint8_t> Document::load_buffer(const Value& buffer) {
  std::vector<uint8_t> bytes = fetch(*this, buffer["uri"]);
  const uint64_t length = buffer["byteLength"].whole(0);
  if (bytes.size() < length)
    buffer["byteLength"].fail(fmt::format("claims {} bytes, but there are {}", length, bytes.size()));
  if (bytes.size() > length + 3) warnings.add("bytes of buffers beyond their byteLength were ignored");
  return bytes;
}

std::span<const uint8_t> Document::buffer(size_t index) {
  const Value buffer = list("buffers")[index];
  const uint64_t length = buffer["byteLength"].whole(0);
  if (!buffer["uri"]) {
    if (index != 0 || !container_.has_binary) buffer.fail("has neither a uri nor the binary chunk of a .glb");
    if (container_.binary.size() < length)
      buffer["byteLength"].fail(
          fmt::format("claims {} bytes, but the binary chunk has {}", length, container_.binary.size()));
    if (container_.binary.size() > length + 3)
      warnings.add("bytes of the binary chunk beyond its byteLength were ignored");
    return container_.binary.first(size_t(length));
  }
  if (!buffers_[index]) buffers_[index] = load_buffer(buffer);
  return std::span(*buffers_[index]).first(size_t(length));
}

std::span<const uint8_t> Document::view(size_t index) {
  const Value view = list("bufferViews")[index];
  if (const Value packed = view.extension("EXT_meshopt_compression")) {
    if (!views_[index]) views_[index] = unpack_meshopt(*this, packed);
    return *views_[index];
  }
  const int source = view["buffer"].index(buffers_.size());
  if (source < 0) view["buffer"].fail("is missing");
  const auto bytes = buffer(size_t(source));
  const uint64_t offset = view["byteOffset"].whole(0), length = view["byteLength"].whole(0);
  if (offset > bytes.size() || length > bytes.size() - offset)
    view.fail(fmt::format("bytes {} to {} lie beyond the buffer's {}", offset, fmt::format("{} + {}", offset, length),
                          bytes.size()));
  return bytes.subspan(size_t(offset), size_t(length));
}

}  // namespace aktina::gltf
