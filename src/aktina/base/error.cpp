#include "aktina/base/error.h"

#include <array>

namespace aktina {
namespace {

constexpr std::array<CodeInfo, 9> kCodes = {{
    {Code::usage, "usage", 2, "UsageError", 400},
    {Code::bad_param, "bad_param", 2, "BadParam", 400},
    {Code::no_such_method, "no_such_method", 2, "NoSuchMethod", 404},
    {Code::bad_input, "bad_input", 3, "BadInput", 422},
    {Code::io, "io", 3, "FileError", 404},
    {Code::limit, "limit", 4, "LimitExceeded", 413},
    {Code::check_failed, "check_failed", 5, "CheckFailed", 409},
    {Code::unsupported, "unsupported", 3, "Unsupported", 415},
    {Code::cancelled, "cancelled", 130, "Cancelled", 499},
}};

constexpr size_t kLongestLine = 600;

std::string compose(const std::string& where, const std::string& what, const std::string& hint) {
  std::string text = where.empty() ? what : where + ": " + what;
  if (!hint.empty()) text += " (" + hint + ")";
  return one_line(text);
}

/// Bytes of the UTF-8 character that `text` begins with; 0 where it is none (overlong forms and surrogates included).
size_t utf8_length(std::string_view text) {
  const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  for (size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const unsigned second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool surrogate = first == 0xed && second >= 0xa0, beyond = first == 0xf4 && second >= 0x90;
  return overlong || surrogate || beyond ? 0 : length;
}

}  // namespace

const CodeInfo& info(Code code) {
  for (const CodeInfo& row : kCodes)
    if (row.code == code) return row;
  return kCodes.front();
}

std::string one_line(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    if (line.size() >= kLongestLine) return line + "...";
    const size_t length = utf8_length(text);
    const auto first = static_cast<unsigned char>(text[0]);
    const bool control = first < 0x20 || first == 0x7f ||
                         (length == 2 && first == 0xc2 && static_cast<unsigned char>(text[1]) < 0xa0);  // C1
    if (length == 0)
      line += "\uFFFD";
    else if (control)
      line += ' ';
    else
      line += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return line;
}

Error::Error(Code code, std::string where, std::string what, std::string hint)
    : std::runtime_error(compose(where, what, hint)),
      code_(code),
      where_(std::move(where)),
      message_(std::move(what)),
      hint_(std::move(hint)) {}

}  // namespace aktina
