// The data of a PLY file, entry by entry.
#include <fmt/core.h>

#include <bit>
#include <cstring>

#include "aktina/base/error.h"
#include "aktina/import/ply/header.h"
#include "aktina/import/text.h"

namespace aktina::ply {
namespace {

template <class T>
double number(const uint8_t* bytes, bool swap) {
  uint8_t own[sizeof(T)];
  for (size_t i = 0; i < sizeof(T); ++i) own[i] = bytes[swap ? sizeof(T) - 1 - i : i];
  T value;
  std::memcpy(&value, own, sizeof(T));
  return double(value);
}

class BinarySource {
 public:
  BinarySource(std::span<const uint8_t> bytes, const Header& header, const std::string& where)
      : all_(bytes.size()), rest_(bytes.subspan(header.data)), where_(where) {
    swap_ = (header.format == Format::little_endian) != (std::endian::native == std::endian::little);
  }
  uint64_t left() const { return rest_.size(); }
  double take(Type type) {
    const size_t size = bytes_of(type);
    if (rest_.size() < size) fail("the file ends too early");
    const uint8_t* p = rest_.data();
    rest_ = rest_.subspan(size);
    switch (type) {
      case Type::i8:
        return number<int8_t>(p, swap_);
      case Type::u8:
        return number<uint8_t>(p, swap_);
      case Type::i16:
        return number<int16_t>(p, swap_);
      case Type::u16:
        return number<uint16_t>(p, swap_);
      case Type::i32:
        return number<int32_t>(p, swap_);
      case Type::u32:
        return number<uint32_t>(p, swap_);
      case Type::f32:
        return number<float>(p, swap_);
      case Type::f64:
        return number<double>(p, swap_);
    }
    return 0;
  }
  [[noreturn]] void fail(std::string what) const {
    throw Error(Code::bad_input, fmt::format("{}: byte {}", where_, all_ - rest_.size()), std::move(what));
  }

 private:
  size_t all_;
  std::span<const uint8_t> rest_;
  const std::string& where_;
  bool swap_ = false;
};

/// Words, wherever the lines end.
class TextSource {
 public:
  TextSource(std::span<const uint8_t> bytes, const Header& header, const std::string& where)
      : lines_({reinterpret_cast<const char*>(bytes.data()) + header.data, bytes.size() - header.data}),
        left_(bytes.size() - header.data + 1),
        first_(header.data_line),
        where_(where) {}
  uint64_t left() const { return left_; }
  double take(Type type) {
    std::string_view word = next_word(line_);
    while (word.empty()) {
      if (!lines_.next(line_)) fail("the file ends too early");
      word = next_word(line_);
    }
    left_ -= std::min<uint64_t>(left_, word.size() + 1);
    double value = 0;
    if (!parse_number(word, value)) fail(fmt::format("'{}' is no number", word.substr(0, 40)));
    if (!is_float(type) && !(value >= -2147483648.0 && value <= 4294967295.0))
      fail(fmt::format("'{}' is beyond the range of its type", word.substr(0, 40)));
    return value;
  }
  [[noreturn]] void fail(std::string what) const {
    throw Error(Code::bad_input, place(where_, first_ + lines_.number() - 1), std::move(what));
  }

 private:
  Lines lines_;
  std::string_view line_;
  uint64_t left_;
  size_t first_;
  const std::string& where_;
};

template <class Source>
void read(Source source, const Header& header, const std::function<void(const Element&, const Entry&)>& use) {
  for (const Element& element : header.elements) {
    const uint64_t least = element.least_bytes(header.format);
    if (least == 0) continue;
    if (element.count > source.left() / least)
      source.fail(fmt::format("{} entries of '{}' are claimed, but only {} bytes are left", element.count, element.name,
                              source.left()));
    Entry entry;
    entry.values.resize(element.properties.size());
    entry.lists.resize(element.properties.size());
    for (uint64_t i = 0; i < element.count; ++i) {
      for (size_t p = 0; p < element.properties.size(); ++p) {
        const Property& property = element.properties[p];
        if (!property.list) {
          entry.values[p] = source.take(property.type);
          continue;
        }
        const double length = source.take(property.count_type);
        const double least_item = header.format == Format::ascii ? 2 : double(bytes_of(property.type));
        if (!(length >= 0 && length <= double(source.left()) / least_item && length == double(uint64_t(length))))
          source.fail(fmt::format("a list of '{}' claims {} values", property.name, length));
        entry.lists[p].resize(size_t(length));
        for (double& value : entry.lists[p]) value = source.take(property.type);
      }
      use(element, entry);
    }
  }
}

}  // namespace

void read_data(std::span<const uint8_t> bytes, const Header& header, const std::string& where,
               const std::function<void(const Element&, const Entry&)>& use) {
  if (header.format == Format::ascii) return read(TextSource(bytes, header, where), header, use);
  read(BinarySource(bytes, header, where), header, use);
}

}  // namespace aktina::ply
