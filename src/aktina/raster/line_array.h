// Arrays for the SIMD code: lines of sixteen values, aligned to 64 bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "aktina/illumination/illuminator.h"

namespace aktina {

template <class T>
struct alignas(64) LanesOf {
  T v[kLanes];
  T& operator[](size_t i) { return v[i]; }
  T operator[](size_t i) const { return v[i]; }
};

/// Padded to whole lines and one more, so that sixteen values can be read from anywhere; zero until written.
template <class T>
class LineArray {
 public:
  void resize(size_t n) { lines_.resize(padded(n) / kLanes + 1); }
  T* data() { return lines_.empty() ? nullptr : lines_.front().v; }
  const T* data() const { return lines_.empty() ? nullptr : lines_.front().v; }
  T& operator[](size_t i) { return lines_[i / kLanes].v[i % kLanes]; }
  T operator[](size_t i) const { return lines_[i / kLanes].v[i % kLanes]; }

 private:
  std::vector<LanesOf<T>> lines_;
};

}  // namespace aktina
