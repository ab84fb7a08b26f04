// Values to bytes and back by one list of fields for both ways. Little endian, as values stand in memory.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "aktina/base/error.h"
#include "aktina/base/function_ref.h"

namespace aktina {

static_assert(std::endian::native == std::endian::little, "values are written as they stand in memory");

/// Goes over fields: writes them, or reads them back in the same order.
class Archive {
 public:
  Archive() = default;
  virtual ~Archive() = default;
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(T& value) { transfer(&value, sizeof value); }
  /// A list of a length that is known: read into a list of another length, the bytes are refused.
  template <class T>
  void operator()(std::vector<T>& list) {
    expect(length(list.size(), sizeof(T)) == list.size());
    items(list);
  }
  /// A list of any length that the bytes fill.
  template <class T>
  void any_length(std::vector<T>& list) {
    list.resize(length(list.size(), sizeof(T)));
    items(list);
  }
  void operator()(std::string& text) {
    text.resize(length(text.size(), 1));
    transfer(text.data(), text.size());
  }
  /// What has to hold of the fields. @throws Error bad_input where bytes are read and it does not
  virtual void expect(bool holds) = 0;

 private:
  template <class T>
  void items(std::vector<T>& list) {
    if constexpr (std::is_trivially_copyable_v<T>)
      transfer(list.data(), list.size() * sizeof(T));
    else
      for (T& item : list) any_length(item);
  }
  virtual void transfer(void* bytes, size_t size) = 0;
  /// Of a list of items of `size` bytes, or at least of one each: that of the list, or that which is read.
  virtual size_t length(size_t own, size_t size) = 0;
};

class ArchiveWriter final : public Archive {
 public:
  using Sink = FunctionRef<void(std::span<const std::byte>)>;
  /// `sink` must outlive this.
  explicit ArchiveWriter(Sink sink) : sink_(sink) {}
  void expect(bool) override {}

 private:
  void transfer(void* bytes, size_t size) override { sink_({static_cast<const std::byte*>(bytes), size}); }
  size_t length(size_t own, size_t) override {
    uint64_t n = own;
    transfer(&n, sizeof n);
    return own;
  }
  Sink sink_;
};

class ArchiveReader final : public Archive {
 public:
  /// @param where  for messages
  ArchiveReader(std::span<const uint8_t> bytes, std::string where) : rest_(bytes), where_(std::move(where)) {}
  bool at_end() const { return rest_.empty(); }
  void expect(bool holds) override {
    if (!holds) throw Error(Code::bad_input, where_, "does not hold what it should: the file is damaged");
  }

 private:
  void transfer(void* bytes, size_t size) override {
    expect(size <= rest_.size());
    if (size > 0) std::memcpy(bytes, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }
  size_t length(size_t, size_t size) override {
    uint64_t n = 0;
    transfer(&n, sizeof n);
    expect(n <= rest_.size() / std::min(size, sizeof n));  // no claim takes memory that the bytes do not fill
    return size_t(n);
  }
  std::span<const uint8_t> rest_;
  std::string where_;
};

}  // namespace aktina
