#include "aktina/import/ply/header.h"

#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/import/text.h"

namespace aktina::ply {
namespace {

constexpr size_t kMostProperties = 1000, kMostElements = 100;

struct TypeName {
  std::string_view name;
  Type type;
};
constexpr TypeName kTypes[] = {
    {"char", Type::i8},   {"int8", Type::i8},     {"uchar", Type::u8},   {"uint8", Type::u8},
    {"short", Type::i16}, {"int16", Type::i16},   {"ushort", Type::u16}, {"uint16", Type::u16},
    {"int", Type::i32},   {"int32", Type::i32},   {"uint", Type::u32},   {"uint32", Type::u32},
    {"float", Type::f32}, {"float32", Type::f32}, {"double", Type::f64}, {"float64", Type::f64},
};

class HeaderReader {
 public:
  HeaderReader(std::span<const uint8_t> bytes, const std::string& where)
      : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()), lines_(text_), where_(where) {}

  Header run() {
    std::string_view line;
    if (!next(line) || trimmed(line) != "ply") fail("does not begin with 'ply'");
    while (next(line)) {
      const std::string_view keyword = next_word(line);
      if (keyword == "end_header") return finish();
      statement(keyword, line);
    }
    fail("ends within its header");
  }

 private:
  bool next(std::string_view& line) {
    if (!lines_.next(line)) return false;
    end_ = size_t(line.data() - text_.data()) + line.size();
    return true;
  }

  void statement(std::string_view keyword, std::string_view rest) {
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return;
    if (keyword == "format") return format(rest);
    if (keyword == "element") return element(rest);
    if (keyword == "property") return property(rest);
    ++header_.unknown_lines;
  }
  void format(std::string_view rest) {
    const std::string_view name = next_word(rest);
    has_format_ = true;
    if (name == "ascii")
      header_.format = Format::ascii;
    else if (name == "binary_little_endian")
      header_.format = Format::little_endian;
    else if (name == "binary_big_endian")
      header_.format = Format::big_endian;
    else
      fail(fmt::format("format '{}' is not known", name.substr(0, 40)));
  }
  void element(std::string_view rest) {
    const std::string_view name = next_word(rest), count = next_word(rest);
    int64_t number = 0;
    if (name.empty() || !parse_number(count, number) || number < 0) fail("element needs a name and a count");
    if (header_.elements.size() == kMostElements) fail("has too many elements");
    for (const Element& other : header_.elements)
      if (other.name == name) fail(fmt::format("element '{}' is declared twice", name.substr(0, 40)));
    expect_end(rest);
    header_.elements.push_back({std::string(name), uint64_t(number), {}});
  }
  void property(std::string_view rest) {
    if (header_.elements.empty()) fail("has a property before the first element");
    if (header_.elements.back().properties.size() == kMostProperties) fail("has too many properties");
    Property p;
    std::string_view word = next_word(rest);
    if (word == "list") {
      p.list = true;
      p.count_type = type(next_word(rest));
      if (is_float(p.count_type)) fail("the length of a list cannot be a float");
      word = next_word(rest);
    }
    p.type = type(word);
    p.name = next_word(rest);
    if (p.name.empty()) fail("property needs a name");
    expect_end(rest);
    header_.elements.back().properties.push_back(std::move(p));
  }
  Type type(std::string_view name) {
    for (const TypeName& row : kTypes)
      if (row.name == name) return row.type;
    fail(fmt::format("type '{}' is not known", name.substr(0, 40)));
  }
  void expect_end(std::string_view rest) {
    if (const std::string_view more = next_word(rest); !more.empty())
      fail(fmt::format("'{}' is one word too many", more.substr(0, 40)));
  }

  Header finish() {
    if (!has_format_) fail("the header states no format");
    header_.data = end_;
    if (text_.substr(header_.data, 2) == "\r\n")
      header_.data += 2;
    else if (header_.data < text_.size())
      header_.data += 1;
    header_.data_line = lines_.number() + 1;
    return std::move(header_);
  }

  [[noreturn]] void fail(std::string what) const {
    throw Error(Code::bad_input, place(where_, std::max<size_t>(lines_.number(), 1)), std::move(what));
  }

  std::string_view text_;
  Lines lines_;
  const std::string& where_;
  size_t end_ = 0;
  bool has_format_ = false;
  Header header_;
};

}  // namespace

size_t bytes_of(Type type) {
  constexpr size_t kBytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[size_t(type)];
}
bool is_float(Type type) { return type == Type::f32 || type == Type::f64; }

uint64_t Element::least_bytes(Format format) const {
  uint64_t bytes = 0;
  for (const Property& p : properties)
    bytes += format == Format::ascii ? 2 : p.list ? bytes_of(p.count_type) : bytes_of(p.type);
  return bytes;
}

Header read_header(std::span<const uint8_t> bytes, const std::string& where) {
  return HeaderReader(bytes, where).run();
}

}  // namespace aktina::ply
