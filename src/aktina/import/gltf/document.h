// One glTF file while it is read: its JSON, its buffers, its allowance of memory, and what was repaired.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "aktina/base/file.h"
#include "aktina/import/gltf/container.h"
#include "aktina/import/gltf/value.h"
#include "aktina/import/import.h"

namespace aktina::gltf {

/// Bytes that a scene may take in all: ImportOptions::most_bytes, and in proportion to the files it is read from, so
/// that a small file cannot fill the machine with what it merely claims.
class Allowance {
 public:
  explicit Allowance(uint64_t most) : most_(most) {}
  void add_input(uint64_t bytes) { input_ += bytes; }
  /// @throws Error limit
  void take(uint64_t bytes, const Value& place);
  /// Bytes that may still be taken.
  uint64_t left() const;

 private:
  uint64_t most_, input_ = 0, taken_ = 0;
};

class Document {
 public:
  Document(std::span<const uint8_t> bytes, Path folder, const std::string& where, const ImportOptions& options);

  Value root() const { return Value(source_); }
  Value list(const char* name) const { return root()[name]; }

  /// Bytes of a buffer or buffer view, read (and decompressed) at first use. @throws Error bad_input, io, limit
  std::span<const uint8_t> buffer(size_t index);
  std::span<const uint8_t> view(size_t index);

  Warnings warnings;
  Allowance allowance;
  const ImportOptions options;
  const Path folder;

 private:
  std::vector<uint8_t> load_buffer(const Value& buffer);

  Container container_;
  JsonPointer json_;
  Source source_;
  std::vector<std::optional<std::vector<uint8_t>>> buffers_, views_;  // of views only decompressed ones
};

/// Bytes of a data: URI, or of a file named relative to the folder, which must not lie outside of it.
/// @throws Error bad_input (malformed), unsupported (other schemes), io (missing), limit
std::vector<uint8_t> fetch(Document& document, const Value& uri);

}  // namespace aktina::gltf
