// Formats without a reader: refused.
#include "aktina/base/error.h"
#include "aktina/import/import.h"

namespace aktina {

Scene read_assimp(std::span<const uint8_t>, const std::string& extension, const Path&, const std::string& where,
                  const ImportOptions&) {
  throw Error(Code::unsupported, where, "scene files with the extension '" + extension + "' are not read",
              "use .glb, .gltf, .obj, .ply, .stl or .off");
}

}  // namespace aktina
