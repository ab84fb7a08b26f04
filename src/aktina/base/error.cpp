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

}  // namespace

const CodeInfo& info(Code code) {
  for (const CodeInfo& row : kCodes)
    if (row.code == code) return row;
  return kCodes.front();
}

std::string one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (line.size() >= kLongestLine) return line + "...";
    line += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
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
