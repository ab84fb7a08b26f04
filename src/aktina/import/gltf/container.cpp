#include "aktina/import/gltf/container.h"

#include <fmt/format.h>

#include <cstring>

#include "aktina/base/error.h"

namespace aktina::gltf {
namespace {

constexpr uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr size_t kHeader = 12, kChunkHeader = 8;

uint32_t word(std::span<const uint8_t> bytes, size_t at) {
  return uint32_t(bytes[at]) | uint32_t(bytes[at + 1]) << 8 | uint32_t(bytes[at + 2]) << 16 |
         uint32_t(bytes[at + 3]) << 24;
}

/// Walks the chunks of a .glb.
class ChunkReader {
 public:
  ChunkReader(std::span<const uint8_t> bytes, const std::string& where, Warnings& warnings)
      : bytes_(bytes), where_(where), warnings_(warnings) {}

  Container read() {
    read_header();
    for (size_t at = kHeader, number = 0; at < bytes_.size(); ++number) at = read_chunk(at, number);
    if (out_.json.empty()) fail(kHeader, "there is no JSON chunk");
    return out_;
  }

 private:
  [[noreturn]] void fail(size_t at, const std::string& what, Code code = Code::bad_input) const {
    throw Error(code, fmt::format("{} byte {}", where_, at), what);
  }

  void read_header() {
    if (bytes_.size() < kHeader) fail(bytes_.size(), "the file ends within its header of 12 bytes");
    if (word(bytes_, 4) != 2) fail(4, fmt::format("GLB version {} is not 2", word(bytes_, 4)), Code::unsupported);
    const uint32_t length = word(bytes_, 8);
    if (length > bytes_.size() || length < kHeader)
      fail(8, fmt::format("the header claims {} bytes, the file has {}", length, bytes_.size()));
    if (length < bytes_.size()) warnings_.add("bytes after the end that a GLB header states were ignored");
    bytes_ = bytes_.first(length);
  }

  size_t read_chunk(size_t at, size_t number) {
    if (bytes_.size() - at < kChunkHeader) fail(at, "the file ends within the header of a chunk");
    const uint32_t length = word(bytes_, at), kind = word(bytes_, at + 4);
    if (length > bytes_.size() - at - kChunkHeader)
      fail(at, fmt::format("a chunk claims {} bytes, {} are left", length, bytes_.size() - at - kChunkHeader));
    if (length % 4 != 0) warnings_.add("chunks of a GLB file whose length is no multiple of 4 were read as they stand");
    const auto data = bytes_.subspan(at + kChunkHeader, length);
    if (number == 0 && kind != kJsonChunk) fail(at, "the first chunk is not JSON");
    if (number > 0 && kind == kJsonChunk) fail(at, "there is a second JSON chunk");
    if (kind == kJsonChunk) out_.json = data;
    if (kind == kBinaryChunk) read_binary(at, number, data);
    return at + kChunkHeader + length;
  }

  void read_binary(size_t at, size_t number, std::span<const uint8_t> data) {
    if (out_.has_binary) fail(at, "there is a second binary chunk");
    if (number != 1) fail(at, "the binary chunk is not the second one");
    if (data.empty()) warnings_.add("the binary chunk is empty");
    out_.binary = data, out_.has_binary = true;
  }

  std::span<const uint8_t> bytes_;
  const std::string& where_;
  Warnings& warnings_;
  Container out_;
};

}  // namespace

bool is_glb(std::span<const uint8_t> bytes) { return bytes.size() >= 4 && word(bytes, 0) == kMagic; }

Container open_container(std::span<const uint8_t> bytes, const std::string& where, Warnings& warnings) {
  if (is_glb(bytes)) return ChunkReader(bytes, where, warnings).read();
  return {bytes, {}, false};
}

}  // namespace aktina::gltf
