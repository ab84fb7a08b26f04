// Which reader a file gets: by its first bytes, then by its extension.
#include <algorithm>
#include <string_view>

#include "aktina/import/gltf/container.h"
#include "aktina/import/import.h"

namespace aktina {
namespace {

/// A .gltf under another name: an object of JSON that says "asset" near its beginning is not looked for further.
bool is_gltf(std::span<const uint8_t> bytes, const std::string& extension) {
  return gltf::is_glb(bytes) || extension == "gltf" || extension == "glb";
}

}  // namespace

Scene load_scene(const Path& path, const ImportOptions& options) {
  const std::vector<uint8_t> bytes = read_file(path, std::min(kLargestFile, options.most_bytes));
  const std::string extension = lower_extension(path), where = display(path);
  if (is_gltf(bytes, extension)) return read_gltf(bytes, path.parent_path(), where, options);
  return read_assimp(bytes, extension, path.parent_path(), where, options);
}

}  // namespace aktina
