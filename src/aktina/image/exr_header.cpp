#include "aktina/image/exr_header.h"

#include <algorithm>
#include <string_view>

#include "aktina/base/error.h"

namespace aktina {
namespace {

constexpr size_t kFirstAttribute = 8;           // after the magic number and the version
constexpr uint8_t kMultiPartFlag = 0x10;        // in byte 5: several headers, an empty one ends them
constexpr uint8_t kDeepFlag = 0x08;             // in byte 5: a part has lists of samples
constexpr size_t kLargestAttribute = 64 << 20;  // previews and the like; pixels are no attributes

/// Types whose values have one size: the library reads that much, whatever the file says, and goes astray.
struct Type {
  std::string_view name;
  size_t size;
};
constexpr Type kTypes[] = {
    {"box2i", 16},
    {"box2f", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33f", 36},
    {"m33d", 72},
    {"m44f", 64},
    {"m44d", 128},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2i", 8},
    {"v2f", 8},
    {"v2d", 16},
    {"v3i", 12},
    {"v3f", 12},
    {"v3d", 24},
};

struct Walk {
  std::span<const uint8_t> rest;
  const std::string& where;

  [[noreturn]] void fail() const {
    throw Error(Code::bad_input, where, "broken OpenEXR: an attribute in the header has a wrong size");
  }
  /// Over a text and the 0 that ends it.
  std::string_view text() {
    const auto end = std::find(rest.begin(), rest.end(), 0);
    if (end == rest.end()) fail();
    const std::string_view found(reinterpret_cast<const char*>(rest.data()), size_t(end - rest.begin()));
    rest = rest.subspan(found.size() + 1);
    return found;
  }
  size_t whole() {
    if (rest.size() < 4) fail();
    const size_t value = size_t(rest[0]) | size_t(rest[1]) << 8 | size_t(rest[2]) << 16 | size_t(rest[3]) << 24;
    rest = rest.subspan(4);
    return value;
  }
  std::span<const uint8_t> take(size_t size) {
    if (size > rest.size() || size > kLargestAttribute) fail();
    const std::span<const uint8_t> taken = rest.first(size);
    rest = rest.subspan(size);
    return taken;
  }

  /// Over a value of the given type and size, which has to end where the library stops reading it.
  void value(std::string_view type) {
    const size_t size = whole();
    Walk inside{take(size), where};
    for (const Type& known : kTypes)
      if (known.name == type && known.size != size) fail();
    if (type == "chlist") {
      while (!inside.text().empty()) inside.take(16);
    } else if (type == "preview") {
      const size_t width = inside.whole(), height = inside.whole();
      if (width > kLargestAttribute || height > kLargestAttribute) fail();
      inside.take(4 * width * height);
    } else if (type == "stringvector") {
      while (!inside.rest.empty()) inside.take(inside.whole());
    } else if (type == "idmanifest") {
      throw Error(Code::unsupported, where, "has an ID manifest");  // the library goes astray in broken ones
    } else {
      return;
    }
    if (!inside.rest.empty()) fail();
  }
  /// Over one header; whether it was empty.
  bool skip_header() {
    for (bool first = true;; first = false) {
      if (text().empty()) return first;
      value(text());
    }
  }
};

}  // namespace

void check_exr_header(std::span<const uint8_t> bytes, const std::string& where) {
  Walk walk{bytes, where};
  if (bytes.size() < kFirstAttribute) walk.fail();
  if ((bytes[5] & kDeepFlag) != 0) throw Error(Code::unsupported, where, "is a deep picture", "flatten it first");
  walk.rest = bytes.subspan(kFirstAttribute);
  if ((bytes[5] & kMultiPartFlag) == 0)
    walk.skip_header();
  else
    while (!walk.skip_header()) continue;
}

}  // namespace aktina
