#include "aktina/import/gltf/accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace aktina::gltf {
namespace {

size_t component_size(Component component) {
  switch (component) {
    case Component::i8:
    case Component::u8:
      return 1;
    case Component::i16:
    case Component::u16:
      return 2;
    case Component::u32:
    case Component::f32:
      return 4;
  }
  return 0;
}

Component component_of(const Value& value) {
  const auto component = Component(value.whole(0));
  if (component_size(component) == 0) value.fail("is not one of 5120, 5121, 5122, 5123, 5125, 5126");
  return component;
}

int width_of(const Value& value) {
  const std::string_view type = value.text_view();
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4" || type == "MAT2") return 4;
  if (type == "MAT3") return 9;
  if (type == "MAT4") return 16;
  value.fail("is not one of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4");
}

/// Bytes of `count` elements from `offset` of a buffer view, each known to lie within.
std::span<const uint8_t> slice(Document& document, const Value& owner, uint64_t count, size_t size, size_t& stride) {
  const int view = owner["bufferView"].index(document.list("bufferViews").size());
  if (view < 0) owner["bufferView"].fail("is missing");
  const auto bytes = document.view(size_t(view));
  const uint64_t own = document.list("bufferViews")[size_t(view)]["byteStride"].whole(0);
  if (own != 0 && (own < size || own > 252))
    owner.fail(fmt::format("elements of {} bytes at a stride of {}", size, own));
  stride = own ? size_t(own) : size;
  const uint64_t offset = owner["byteOffset"].whole(0);
  const uint64_t room = offset <= bytes.size() ? bytes.size() - offset : 0;
  if (count > 0 && (room < size || count - 1 > (room - size) / stride))
    owner.fail(
        fmt::format("{} elements of {} bytes do not fit into a buffer view of {} bytes", count, size, bytes.size()));
  return bytes.subspan(std::min(size_t(offset), bytes.size()));
}

template <class T>
T load(const uint8_t* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

template <class T>
float as_float(T value, bool normalized) {
  if constexpr (std::is_floating_point_v<T>) return value;
  const float scaled = normalized ? float(double(value) / double(std::numeric_limits<T>::max())) : float(value);
  return normalized ? std::max(scaled, -1.0f) : scaled;
}

/// Columns of matrices of bytes and shorts start at multiples of 4 bytes.
int padded_offset(int i, int width, size_t size) {
  if (width < 9 || size == 4) return i;
  const int rows = width == 9 ? 3 : 4, column = i / rows, row = i % rows;
  const int pitch = int((size_t(rows) * size + 3) / 4 * 4 / size);
  return column * pitch + row;
}

template <class T>
void convert(const Accessor& a, uint64_t first, uint64_t count, float* out) {
  for (uint64_t i = 0; i < count; ++i) {
    const uint8_t* element = a.bytes.data() + (first + i) * a.stride;
    for (int k = 0; k < a.width; ++k)
      *out++ = as_float(load<T>(element + size_t(padded_offset(k, a.width, sizeof(T))) * sizeof(T)), a.normalized);
  }
}

void convert(const Accessor& a, uint64_t first, uint64_t count, float* out) {
  if (a.bytes.empty()) return;
  switch (a.component) {
    case Component::i8:
      return convert<int8_t>(a, first, count, out);
    case Component::u8:
      return convert<uint8_t>(a, first, count, out);
    case Component::i16:
      return convert<int16_t>(a, first, count, out);
    case Component::u16:
      return convert<uint16_t>(a, first, count, out);
    case Component::u32:
      return convert<uint32_t>(a, first, count, out);
    case Component::f32:
      return convert<float>(a, first, count, out);
  }
}

std::vector<uint32_t> convert_whole(const Accessor& a) {
  std::vector<uint32_t> out(size_t(a.count), 0);
  if (a.bytes.empty()) return out;
  for (size_t i = 0; i < out.size(); ++i) {
    const uint8_t* element = a.bytes.data() + i * a.stride;
    if (a.component == Component::u8) out[i] = *element;
    if (a.component == Component::u16) out[i] = load<uint16_t>(element);
    if (a.component == Component::u32) out[i] = load<uint32_t>(element);
  }
  return out;
}

/// The replaced elements of a sparse accessor: where, and what.
struct Sparse {
  std::vector<uint32_t> indices;
  Accessor values;
};

Sparse open_sparse(Document& document, const Accessor& accessor) {
  const Value place = accessor.place["sparse"];
  const uint64_t count = place["count"].whole(0);
  if (count > accessor.count) place["count"].fail(fmt::format("{} of {} elements", count, accessor.count));
  Accessor indices(place["indices"]);
  indices.component = component_of(place["indices"]["componentType"]);
  if (indices.component != Component::u8 && indices.component != Component::u16 && indices.component != Component::u32)
    place["indices"]["componentType"].fail("should be 5121, 5123 or 5125");
  indices.count = count;
  indices.bytes = slice(document, place["indices"], count, component_size(indices.component), indices.stride);
  Sparse out{convert_whole(indices), accessor};
  for (size_t i = 0; i < out.indices.size(); ++i) {
    if (out.indices[i] >= accessor.count)
      place["indices"].fail(fmt::format("element {} of {} is replaced", out.indices[i], accessor.count));
    if (i > 0 && out.indices[i] <= out.indices[i - 1]) place["indices"].fail("should increase strictly");
  }
  const size_t size = component_size(accessor.component) * size_t(accessor.width);
  out.values.bytes = slice(document, place["values"], count, size, out.values.stride);
  return out;
}

}  // namespace

Accessor refer_to_accessor(Document& document, const Value& index) {
  const Value list = document.list("accessors");
  const int number = index.index(list.size());
  if (number < 0) index.fail("is missing");
  return open_accessor(document, list[size_t(number)]);
}

Accessor open_accessor(Document& document, const Value& place) {
  Accessor out(place);
  out.component = component_of(out.place["componentType"]);
  out.normalized = out.place["normalized"].flag(false);
  out.width = width_of(out.place["type"]);
  out.count = out.place["count"].whole(0);
  if (out.count == 0) out.place["count"].fail("should be at least 1");
  if (out.count > std::numeric_limits<uint32_t>::max() - 1)
    out.place["count"].fail("is more than indices can name", Code::limit);
  const size_t numbers = size_t(padded_offset(out.width - 1, out.width, component_size(out.component))) + 1;
  if (out.place["bufferView"])
    out.bytes = slice(document, out.place, out.count, numbers * component_size(out.component), out.stride);
  return out;
}

std::vector<float> read_floats(Document& document, const Accessor& accessor, uint64_t first, uint64_t count) {
  std::vector<float> out(size_t(count) * size_t(accessor.width), 0);
  convert(accessor, first, count, out.data());
  if (!accessor.place["sparse"]) return out;
  const Sparse sparse = open_sparse(document, accessor);
  for (size_t i = 0; i < sparse.indices.size(); ++i)
    if (sparse.indices[i] >= first && sparse.indices[i] - first < count)
      convert(sparse.values, i, 1, out.data() + (sparse.indices[i] - first) * size_t(accessor.width));
  return out;
}

std::vector<uint32_t> read_whole(Document& document, const Accessor& accessor) {
  if (accessor.width != 1 || accessor.component == Component::f32 || accessor.component == Component::i8 ||
      accessor.component == Component::i16 || accessor.normalized)
    accessor.place.fail("should be whole numbers without a sign");
  std::vector<uint32_t> out = convert_whole(accessor);
  if (!accessor.place["sparse"]) return out;
  const Sparse sparse = open_sparse(document, accessor);
  Accessor values = sparse.values;
  values.count = sparse.indices.size();
  const std::vector<uint32_t> replaced = convert_whole(values);
  for (size_t i = 0; i < replaced.size(); ++i) out[sparse.indices[i]] = replaced[i];
  return out;
}

}  // namespace aktina::gltf
