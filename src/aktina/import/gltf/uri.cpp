// data: URIs and relative references.
#include <array>
#include <string_view>
#include <system_error>

#include "aktina/import/gltf/document.h"

namespace aktina::gltf {
namespace {

int hex(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// %41 -> A. A percent sign that no two digits follow stays: exporters forget to encode it.
std::string percent_decoded(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (size_t i = 0; i < text.size(); ++i) {
    const bool code = text[i] == '%' && i + 2 < text.size() && hex(text[i + 1]) >= 0 && hex(text[i + 2]) >= 0;
    out += code ? char(hex(text[i + 1]) * 16 + hex(text[i + 2])) : text[i];
    if (code) i += 2;
  }
  return out;
}

constexpr std::array<int, 256> base64_values() {
  std::array<int, 256> values{};
  for (int& value : values) value = -1;
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (size_t i = 0; i < kAlphabet.size(); ++i) values[uint8_t(kAlphabet[i])] = int(i);
  values['-'] = 62, values['_'] = 63;  // the alphabet for URLs
  return values;
}

std::vector<uint8_t> base64_decoded(std::string_view text, const Value& place) {
  static constexpr std::array<int, 256> kValues = base64_values();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::vector<uint8_t> out;
  out.reserve(text.size() / 4 * 3 + 3);
  uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int value = kValues[uint8_t(c)];
    if (value < 0) place.fail("is not valid Base64");
    bits = bits << 6 | uint32_t(value), count += 6;
    if (count >= 8) count -= 8, out.push_back(uint8_t(bits >> count));
  }
  if (text.size() % 4 == 1) place.fail("is Base64 that ends too early");
  return out;
}

std::vector<uint8_t> decode_data_uri(std::string_view text, const Value& place) {
  const size_t comma = text.find(',');
  if (comma == text.npos) place.fail("is a data URI without data");
  const std::string_view kind = text.substr(0, comma), data = text.substr(comma + 1);
  if (kind.ends_with(";base64")) return base64_decoded(data, place);
  const std::string bytes = percent_decoded(data);
  return {bytes.begin(), bytes.end()};
}

/// Whether a scheme as in "https:" stands in front; one letter is a drive of Windows, which is refused as well.
bool has_scheme(std::string_view text) {
  const size_t colon = text.find(':');
  return colon != text.npos && text.find('/') > colon && text.find_first_of(" %") > colon;
}

/// Below `folder` by its name, and after links are followed.
Path confined(const Document& document, const std::string& name, const Value& place) {
  const auto refuse = [&] {
    place.fail("refers to a file outside of the scene's folder", Code::bad_input, "move it beside the scene");
  };
  if (name.find('\0') != name.npos) place.fail("contains a zero byte");
  const Path relative(std::u8string(name.begin(), name.end()));
  if (relative.is_absolute() || has_scheme(name)) refuse();
  const Path normal = relative.lexically_normal();
  if (!normal.empty() && *normal.begin() == "..") refuse();
  std::error_code error;
  const Path folder = document.folder.empty() ? Path(".") : document.folder;
  const Path root = std::filesystem::weakly_canonical(folder, error);
  const Path full = error ? Path() : std::filesystem::weakly_canonical(folder / normal, error);
  const Path below = full.lexically_relative(root);
  if (error || below.empty() || *below.begin() == "..") refuse();
  return folder / normal;
}

}  // namespace

std::vector<uint8_t> fetch(Document& document, const Value& uri) {
  const std::string_view text = uri.text_view();
  if (text.starts_with("data:")) {
    document.allowance.take(text.size() / 4 * 3, uri);
    return decode_data_uri(text, uri);
  }
  std::vector<uint8_t> bytes;
  try {
    const Path path = confined(document, percent_decoded(text), uri);
    bytes = read_file(path, std::min(kLargestFile, document.options.most_bytes));
  } catch (const Error& error) {
    if (error.where() == uri.place()) throw;
    uri.fail(error.where() + ": " + error.message(), error.code());
  }
  document.allowance.add_input(bytes.size());
  document.allowance.take(bytes.size(), uri);
  return bytes;
}

}  // namespace aktina::gltf
