// Files -> Scene. No file may crash, hang, or exhaust the machine: docs/input.md lists what is repaired and refused.
#pragma once

#include <span>
#include <string>

#include "aktina/base/file.h"
#include "aktina/base/progress.h"
#include "aktina/scene/scene.h"

namespace aktina {

struct ImportOptions {
  double metres_per_unit = 0;  // 0: what the format says (glTF: 1), or guessed for formats without a unit (1)
  std::string normals{};       // of normals(): made anew for every mesh by this method; empty: those of the file
  float crease = 0.5236f;      // rad; edges sharper than this stay sharp where normals are made
  uint64_t most_bytes = uint64_t(8) << 30;  // of memory for the scene; more is refused
  bool default_camera = true, default_light = true;
  /// A picture of the surroundings that shines on the scene, in place of its own; empty: none. See environment_of().
  Path environment{};
  double environment_scale = 1;     // from its values to cd/m^2
  double environment_rotation = 0;  // rad about +y
};

/// Any scene file Aktina reads: glTF 2.0 (.gltf, .glb), OBJ, PLY, STL, OFF, FBX, COLLADA (.dae), 3DS.
/// By content first, then by the extension.
/// @throws Error bad_input, io, limit, unsupported
Scene load_scene(const Path& path, const ImportOptions& options = {});

/// One reader each, for tests and fuzzers; `folder` resolves relative references (never outside of it).
Scene read_gltf(std::span<const uint8_t> bytes, const Path& folder, const std::string& where,
                const ImportOptions& options = {});
Scene read_obj(std::span<const uint8_t> bytes, const Path& folder, const std::string& where,
               const ImportOptions& options = {});
Scene read_ply(std::span<const uint8_t> bytes, const std::string& where, const ImportOptions& options = {});
Scene read_stl(std::span<const uint8_t> bytes, const std::string& where, const ImportOptions& options = {});
Scene read_off(std::span<const uint8_t> bytes, const std::string& where, const ImportOptions& options = {});
Scene read_fbx(std::span<const uint8_t> bytes, const Path& folder, const std::string& where,
               const ImportOptions& options = {});
Scene read_collada(std::span<const uint8_t> bytes, const Path& folder, const std::string& where,
                   const ImportOptions& options = {});
Scene read_3ds(std::span<const uint8_t> bytes, const Path& folder, const std::string& where,
               const ImportOptions& options = {});

}  // namespace aktina
