#include "aktina/image/exr_header.h"

#include <algorithm>
#include <cstring>

#include "aktina/base/error.h"

namespace aktina {
namespace {

constexpr size_t kFirstAttribute = 8;           // after the magic number and the version
constexpr uint8_t kMultiPartFlag = 0x10;        // in byte 5: several headers, an empty one ends them
constexpr size_t kLargestAttribute = 64 << 20;  // previews and the like; pixels are no attributes

struct Walk {
  std::span<const uint8_t> rest;
  const std::string& where;

  [[noreturn]] void fail() const { throw Error(Code::bad_input, where, "broken OpenEXR: the header is truncated"); }
  /// Over a text and the 0 that ends it; whether it was empty.
  bool skip_text() {
    const auto end = std::find(rest.begin(), rest.end(), 0);
    if (end == rest.end()) fail();
    const bool empty = end == rest.begin();
    rest = rest.subspan(size_t(end - rest.begin()) + 1);
    return empty;
  }
  void skip_value() {
    if (rest.size() < 4) fail();
    const size_t size = size_t(rest[0]) | size_t(rest[1]) << 8 | size_t(rest[2]) << 16 | size_t(rest[3]) << 24;
    rest = rest.subspan(4);
    if (size > rest.size() || size > kLargestAttribute) fail();
    rest = rest.subspan(size);
  }
  /// Over one header; whether it was empty.
  bool skip_header() {
    for (bool first = true;; first = false) {
      if (skip_text()) return first;
      skip_text();
      skip_value();
    }
  }
};

}  // namespace

void check_exr_header(std::span<const uint8_t> bytes, const std::string& where) {
  Walk walk{bytes, where};
  if (bytes.size() < kFirstAttribute) walk.fail();
  walk.rest = bytes.subspan(kFirstAttribute);
  if ((bytes[5] & kMultiPartFlag) == 0)
    walk.skip_header();
  else
    while (!walk.skip_header()) continue;
}

}  // namespace aktina
