// A fast 64-bit hash of bytes: names a scene or a set of options in a report. Not for security.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

namespace aktina {

class Hash64 {
 public:
  void add(std::span<const std::byte> bytes) {
    size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
      uint64_t word = 0;
      std::memcpy(&word, bytes.data() + i, 8);
      mix(word);
    }
    uint64_t tail = 0;
    if (i < bytes.size()) std::memcpy(&tail, bytes.data() + i, bytes.size() - i);
    mix(tail ^ (uint64_t(bytes.size()) << 56));
  }
  void add(std::string_view text) { add(std::as_bytes(std::span(text))); }
  template <class T>
  void add_values(std::span<const T> values) {
    add(std::as_bytes(values));
  }
  template <class T>
  void add_value(const T& value) {
    add(std::as_bytes(std::span(&value, 1)));
  }
  uint64_t value() const { return finish(state_); }
  /// 16 hexadecimal digits.
  std::string text() const {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string out(16, '0');
    for (uint64_t v = value(), i = 16; i-- > 0; v >>= 4) out[i] = kDigits[v & 15];
    return out;
  }

 private:
  // Stafford's variant 13 of MurmurHash3's finalizer.
  static uint64_t finish(uint64_t x) {
    x ^= x >> 30, x *= 0xbf58476d1ce4e5b9ULL, x ^= x >> 27, x *= 0x94d049bb133111ebULL, x ^= x >> 31;
    return x;
  }
  void mix(uint64_t word) { state_ = finish(state_ ^ word) + 0x9e3779b97f4a7c15ULL; }
  uint64_t state_ = 0x2545f4914f6cdd1dULL;
};

}  // namespace aktina
