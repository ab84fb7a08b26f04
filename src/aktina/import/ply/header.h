// The header of a PLY file, and the walk over its data. G. Turk, "The PLY Polygon File Format", Stanford, 1994.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aktina::ply {

enum class Format : uint8_t { ascii, little_endian, big_endian };
enum class Type : uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };
size_t bytes_of(Type type);
bool is_float(Type type);

struct Property {
  std::string name;
  Type type;
  bool list = false;
  Type count_type = Type::u8;  // of a list
};

struct Element {
  std::string name;
  uint64_t count = 0;
  std::vector<Property> properties;
  uint64_t least_bytes(Format format) const;  // of one entry
};

struct Header {
  Format format = Format::ascii;
  std::vector<Element> elements;
  uint64_t unknown_lines = 0;  // that are no statement of PLY
  size_t data = 0;             // where the data begin
  size_t data_line = 0;        // number of that line
};

/// @throws Error bad_input, unsupported, with the line
Header read_header(std::span<const uint8_t> bytes, const std::string& where);

/// One entry of an element: a value for each property that is no list, and the values of each list.
struct Entry {
  std::vector<double> values;              // by property; 0 for lists
  std::vector<std::vector<double>> lists;  // by property; empty for others
};

/// Calls `use` for each entry in order. @throws Error bad_input where data are missing or unreadable
void read_data(std::span<const uint8_t> bytes, const Header& header, const std::string& where,
               const std::function<void(const Element&, const Entry&)>& use);

}  // namespace aktina::ply
