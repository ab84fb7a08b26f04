// What tests of readers share.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "aktina/import/import.h"

namespace aktina::test {

inline std::span<const uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

/// What is in the file and no more.
inline ImportOptions bare() {
  ImportOptions options;
  options.default_camera = options.default_light = false;
  return options;
}

/// How often a warning that holds `part` was given.
inline uint64_t warned(const Scene& scene, std::string_view part) {
  for (const auto& item : scene.warnings.items())
    if (item.text.find(part) != std::string::npos) return item.count;
  return 0;
}

}  // namespace aktina::test
