// Comma-separated values as RFC 4180 has them.
#pragma once

#include <string>
#include <string_view>

namespace aktina {

/// The text as one field, in quotes where it needs them.
inline std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n#") == text.npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

}  // namespace aktina
