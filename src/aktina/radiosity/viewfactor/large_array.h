// Numbers by the hundred million: memory that is taken page by page as it is written, or a file in its place.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <utility>

namespace aktina {

/// Zeroed memory straight from the system, in huge pages where there are any.
class LargeBlock {
 public:
  LargeBlock() = default;
  /// @param folder  where a file without a name holds the bytes in place of memory; empty: memory
  /// @throws Error limit (no memory), io (no room in the folder)
  explicit LargeBlock(size_t bytes, const std::filesystem::path& folder = {});
  LargeBlock(LargeBlock&& other) noexcept { *this = std::move(other); }
  LargeBlock& operator=(LargeBlock&& other) noexcept {
    std::swap(data_, other.data_), std::swap(bytes_, other.bytes_);
    return *this;
  }
  ~LargeBlock();
  void* data() const { return data_; }
  size_t bytes() const { return bytes_; }

 private:
  void* data_ = nullptr;
  size_t bytes_ = 0;
};

template <class T>
class LargeArray {
 public:
  using value_type = T;
  LargeArray() = default;
  /// Zeros. See LargeBlock.
  explicit LargeArray(size_t size, const std::filesystem::path& folder = {})
      : block_(size * sizeof(T), folder), size_(size) {}
  LargeArray(std::initializer_list<T> values) : LargeArray(values.size()) {
    std::copy(values.begin(), values.end(), begin());
  }
  LargeArray(const LargeArray& other) : LargeArray(other.size_) { std::copy(other.begin(), other.end(), begin()); }
  LargeArray(LargeArray&& other) noexcept = default;
  LargeArray& operator=(LargeArray other) noexcept {
    block_ = std::move(other.block_), size_ = other.size_;
    return *this;
  }

  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return static_cast<T*>(block_.data()); }
  const T* data() const { return static_cast<const T*>(block_.data()); }
  T& operator[](size_t i) { return data()[i]; }
  const T& operator[](size_t i) const { return data()[i]; }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  friend bool operator==(const LargeArray& a, const LargeArray& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  LargeBlock block_;
  size_t size_ = 0;
};

}  // namespace aktina
