// Text files as they come: any line ends, any of the Unicode encodings with a mark, words and numbers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aktina {

/// UTF-8 without its mark; UTF-16 with a mark is converted; anything else is left as it is.
std::string decode_text(std::span<const uint8_t> bytes);

/// Bytes that are no UTF-8 taken as ISO 8859-1.
std::string utf8_or_latin1(std::string_view text);

/// Lines that end in LF, CR LF or CR, without their ends, numbered from 1.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  bool next(std::string_view& line);
  size_t number() const { return number_; }

 private:
  std::string_view rest_;
  size_t number_ = 0;
};

/// Cuts the first word (separated by blanks and tabs) off `text`; empty where there is none.
std::string_view next_word(std::string_view& text);
/// Without blanks and control characters at both ends.
std::string_view trimmed(std::string_view text);
std::string lower_case(std::string_view text);

/// The whole word as a number: digits as usual, "+1", ".5", "1.e3", "nan", "inf". Beyond the range of floats: infinite.
bool parse_number(std::string_view word, double& value);
bool parse_number(std::string_view word, float& value);
/// The whole word as a whole number; false beyond 64 bits.
bool parse_number(std::string_view word, int64_t& value);

/// "scene.obj:12"
std::string place(const std::string& where, size_t line);

/// The fields of a line of comma-separated values, trimmed: quotes around a field, doubled within it.
std::vector<std::string> csv_fields(std::string_view line);

}  // namespace aktina
