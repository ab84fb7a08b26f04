// Short forms for the rows of the schema's tables.
#pragma once

#include "aktina/import/gltf/schema.h"

namespace aktina::gltf::rows {

using Kind = Property::Kind;

inline constexpr double kAny = 1e38, kLargestWhole = 9007199254740992.0;  // 2^53
inline constexpr double kTiny = 1e-38;                                    // the least number above 0

constexpr Property flag(std::string_view name) { return {name, Kind::flag}; }
constexpr Property text(std::string_view name) { return {name, Kind::text}; }
constexpr Property whole(std::string_view name, double low = 0, double high = kLargestWhole) {
  return {name, Kind::whole, low, high};
}
constexpr Property number(std::string_view name, double low = -kAny, double high = kAny) {
  return {name, Kind::number, low, high};
}
constexpr Property numbers(std::string_view name, size_t count, double low = -kAny, double high = kAny) {
  return {name, Kind::numbers, low, high, count, count};
}
constexpr Property object(std::string_view name, const Shape& shape) {
  return {.name = name, .kind = Kind::object, .shape = &shape};
}
constexpr Property objects(std::string_view name, const Shape& shape) {
  return {.name = name, .kind = Kind::objects, .shape = &shape};
}
constexpr Property reference(std::string_view name, std::string_view list) {
  return {.name = name, .kind = Kind::reference, .list = list};
}
constexpr Property references(std::string_view name, std::string_view list) {
  return {.name = name, .kind = Kind::references, .list = list};
}
constexpr Property map(std::string_view name, std::string_view list) {
  return {.name = name, .kind = Kind::map, .list = list};
}
constexpr Property maps(std::string_view name, std::string_view list) {
  return {.name = name, .kind = Kind::maps, .list = list};
}
constexpr Property required(Property property) {
  property.required = true;
  return property;
}

extern const Shape kTextureInfo;

}  // namespace aktina::gltf::rows
