// FBX, COLLADA and 3DS -> Scene, by Assimp in a process of its own.
#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/import/assimp/apart.h"
#include "aktina/import/assimp/build.h"
#include "aktina/import/assimp/parse.h"
#include "aktina/import/mesh_tools.h"

namespace aktina {
namespace {

constexpr unsigned kLeastSeconds = 30;                  // of computing time
constexpr uint64_t kLeastMemory = uint64_t(256) << 20;  // bytes, and as much again for each byte of the file:
constexpr uint64_t kMemoryAByte = 256;                  // claims of damaged files end there
constexpr uint64_t kBytesASecond = uint64_t(1) << 18;   // a tenth of what a slow machine reads

Scene read_apart(assimp::Format format, std::span<const uint8_t> bytes, const Path& folder, const std::string& where,
                 const ImportOptions& options) {
  check_memory(bytes.size(), where, options);
  const uint64_t memory = std::min(options.most_bytes, kLeastMemory + kMemoryAByte * bytes.size());
  const assimp::Limits limits{memory, kLeastSeconds + unsigned(bytes.size() / kBytesASecond)};
  assimp::Document document;
  assimp::run_apart(
      limits, where,
      [&](const assimp::Sink& sink) {
        assimp::Document found = assimp::parse(bytes, format, memory);
        assimp::write(found, sink);
      },
      [&](const assimp::Source& source) { document = assimp::read(source, memory, where); });
  Scene scene;
  scene.source = where;
  Beside beside(folder, options);
  assimp::build(std::move(document), beside, options, scene);
  ImportOptions placed = options;
  placed.metres_per_unit = 0;  // units are in the nodes already
  finish_scene(scene, placed, "");
  return scene;
}

}  // namespace

Scene read_fbx(std::span<const uint8_t> bytes, const Path& folder, const std::string& where,
               const ImportOptions& options) {
  return read_apart(assimp::Format::fbx, bytes, folder, where, options);
}

Scene read_collada(std::span<const uint8_t> bytes, const Path& folder, const std::string& where,
                   const ImportOptions& options) {
  return read_apart(assimp::Format::collada, bytes, folder, where, options);
}

Scene read_3ds(std::span<const uint8_t> bytes, const Path& folder, const std::string& where,
               const ImportOptions& options) {
  return read_apart(assimp::Format::max3ds, bytes, folder, where, options);
}

}  // namespace aktina
