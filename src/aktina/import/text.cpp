#include "aktina/import/text.h"

#include <charconv>
#include <cstdlib>

#include "aktina/base/error.h"

namespace aktina {
namespace {

void append_utf8(std::string& out, uint32_t c) {
  if (c < 0x80) {
    out += char(c);
  } else if (c < 0x800) {
    out += char(0xc0 | c >> 6), out += char(0x80 | (c & 0x3f));
  } else if (c < 0x10000) {
    out += char(0xe0 | c >> 12), out += char(0x80 | (c >> 6 & 0x3f)), out += char(0x80 | (c & 0x3f));
  } else {
    out += char(0xf0 | c >> 18), out += char(0x80 | (c >> 12 & 0x3f));
    out += char(0x80 | (c >> 6 & 0x3f)), out += char(0x80 | (c & 0x3f));
  }
}

std::string from_utf16(std::span<const uint8_t> bytes, bool big_endian) {
  std::string out;
  out.reserve(bytes.size() / 2);
  const auto unit = [&](size_t i) -> uint32_t {
    return big_endian ? uint32_t(bytes[i]) << 8 | bytes[i + 1] : uint32_t(bytes[i + 1]) << 8 | bytes[i];
  };
  for (size_t i = 0; i + 1 < bytes.size(); i += 2) {
    uint32_t c = unit(i);
    const bool surrogate = c >= 0xd800 && c < 0xe000;
    if (surrogate && c < 0xdc00 && i + 3 < bytes.size() && (unit(i + 2) & 0xfc00) == 0xdc00) {
      c = 0x10000 + ((c & 0x3ff) << 10) + (unit(i + 2) & 0x3ff);
      i += 2;
    } else if (surrogate) {
      c = 0xfffd;
    }
    append_utf8(out, c);
  }
  return out;
}

}  // namespace

std::string decode_text(std::span<const uint8_t> b) {
  if (b.size() >= 2 && b[0] == 0xfe && b[1] == 0xff) return from_utf16(b.subspan(2), true);
  if (b.size() >= 2 && b[0] == 0xff && b[1] == 0xfe) return from_utf16(b.subspan(2), false);
  if (b.size() >= 3 && b[0] == 0xef && b[1] == 0xbb && b[2] == 0xbf) b = b.subspan(3);
  return {reinterpret_cast<const char*>(b.data()), b.size()};
}

std::string utf8_or_latin1(std::string_view text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const size_t length = byte >= 0xf0 ? 4 : byte >= 0xe0 ? 3 : byte >= 0xc2 ? 2 : 1;
    bool valid = length > 1 && i + length <= text.size();
    for (size_t k = 1; valid && k < length; ++k) valid = (static_cast<unsigned char>(text[i + k]) & 0xc0) == 0x80;
    if (valid) {
      out += text.substr(i, length);
      i += length - 1;
    } else {
      append_utf8(out, byte);
    }
  }
  return out;
}

bool Lines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const size_t end = rest_.find_first_of("\r\n");
  line = rest_.substr(0, end);
  const size_t skip = end == rest_.npos ? rest_.size() : rest_.substr(end, 2) == "\r\n" ? end + 2 : end + 1;
  rest_.remove_prefix(skip);
  ++number_;
  return true;
}

std::string_view next_word(std::string_view& text) {
  constexpr std::string_view kBlank = " \t\v\f";
  const size_t begin = text.find_first_not_of(kBlank);
  if (begin == text.npos) return text = {};
  const size_t end = std::min(text.find_first_of(kBlank, begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return static_cast<unsigned char>(c) <= ' '; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return out;
}

bool parse_number(std::string_view word, double& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return false;
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(word).c_str(), nullptr);
  return error != std::errc::invalid_argument;
}

bool parse_number(std::string_view word, float& value) {
  double wide = 0;
  if (!parse_number(word, wide)) return false;
  value = float(wide);
  return true;
}

bool parse_number(std::string_view word, int64_t& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

std::string place(const std::string& where, size_t line) { return where + ":" + std::to_string(line); }

std::vector<std::string> csv_fields(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += '"', ++i;
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += line[i];
  }
  for (std::string& field : fields) field = std::string(trimmed(field));
  return fields;
}

}  // namespace aktina
