// Accessors: typed, strided, normalized, sparse views of a buffer's bytes -> plain arrays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aktina/import/gltf/document.h"

namespace aktina::gltf {

/// glTF's component types, by their OpenGL numbers.
enum class Component : uint32_t { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

struct Accessor {
  explicit Accessor(const Value& where) : place(where) {}

  Value place;
  Component component = Component::f32;
  bool normalized = false;
  int width = 1;                   // numbers an element: 1 to 4, 9, 16
  uint64_t count = 0;              // elements
  std::span<const uint8_t> bytes;  // from the first element; empty: zeros
  size_t stride = 0;
};

/// Checked against its buffer view: every element lies within. @throws Error bad_input
Accessor open_accessor(Document& document, const Value& place);
/// The same of the accessor whose number stands at `index`.
Accessor refer_to_accessor(Document& document, const Value& index);

/// Elements [first, first + count) as floats, `width` for each, sparse values put in; normalized integers as glTF maps
/// them to [0, 1] or [-1, 1]. The caller has checked the range and asked for the memory.
std::vector<float> read_floats(Document& document, const Accessor& accessor, uint64_t first, uint64_t count);

/// Whole numbers of an accessor of scalars without a sign.
std::vector<uint32_t> read_whole(Document& document, const Accessor& accessor);

}  // namespace aktina::gltf
