// Which reader a file gets: by its first bytes, then by its extension.
#include <algorithm>
#include <cstring>
#include <string_view>

#include "aktina/base/error.h"
#include "aktina/import/environment.h"
#include "aktina/import/gltf/container.h"
#include "aktina/import/import.h"

namespace aktina {
namespace {

/// A .gltf under another name: an object of JSON that says "asset" near its beginning is not looked for further.
bool is_gltf(std::span<const uint8_t> bytes, const std::string& extension) {
  return gltf::is_glb(bytes) || extension == "gltf" || extension == "glb";
}

bool starts_with(std::span<const uint8_t> bytes, std::string_view text) {
  return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).starts_with(text);
}

/// OFF, COFF, NOFF, STOFF and their mixtures.
bool is_off(std::span<const uint8_t> bytes) {
  const size_t end =
      std::string_view(reinterpret_cast<const char*>(bytes.data()), std::min<size_t>(bytes.size(), 8)).find("OFF");
  return end <= 4 &&
         std::all_of(bytes.begin(), bytes.begin() + long(end), [](uint8_t c) { return c >= 'A' && c <= 'Z'; });
}

bool is_fbx(std::span<const uint8_t> bytes, const std::string& extension) {
  return extension == "fbx" || starts_with(bytes, "Kaydara FBX Binary") || starts_with(bytes, "; FBX");
}

bool is_collada(std::span<const uint8_t> bytes, const std::string& extension) {
  constexpr size_t kHead = 1024;  // bytes in which a document names its root
  const std::string_view head(reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), kHead));
  return extension == "dae" || head.find("<COLLADA") != head.npos;
}

/// The first chunk, 0x4D4D, is as long as the file.
bool is_3ds(std::span<const uint8_t> bytes, const std::string& extension) {
  uint32_t length = 0;
  if (bytes.size() >= 6) std::memcpy(&length, bytes.data() + 2, 4);
  return extension == "3ds" || (starts_with(bytes, "MM") && length == bytes.size());
}

Scene read_any(const Path& path, const ImportOptions& options) {
  const std::vector<uint8_t> bytes = read_file(path, std::min(kLargestFile, options.most_bytes));
  const std::string extension = lower_extension(path), where = display(path);
  if (is_gltf(bytes, extension)) return read_gltf(bytes, path.parent_path(), where, options);
  if (starts_with(bytes, "ply\n") || starts_with(bytes, "ply\r") || extension == "ply")
    return read_ply(bytes, where, options);
  if (extension == "obj") return read_obj(bytes, path.parent_path(), where, options);
  if (extension == "off" || is_off(bytes)) return read_off(bytes, where, options);
  if (extension == "stl" || starts_with(bytes, "solid")) return read_stl(bytes, where, options);
  if (is_fbx(bytes, extension)) return read_fbx(bytes, path.parent_path(), where, options);
  if (is_collada(bytes, extension)) return read_collada(bytes, path.parent_path(), where, options);
  if (is_3ds(bytes, extension)) return read_3ds(bytes, path.parent_path(), where, options);
  throw Error(Code::unsupported, where, "scene files with the extension '" + extension + "' are not read",
              "use .glb, .gltf, .obj, .ply, .stl, .off, .fbx, .dae or .3ds");
}

/// Of all meshes, with vertices doubled at creases.
void renew_normals(Scene& scene, const ImportOptions& options) {
  const FacetWeighting weighting = make_method(normals(), "normals", options.normals);
  for (Mesh& mesh : scene.meshes) {
    mesh.normals.clear();
    generate_normals(mesh, options.crease, weighting);
  }
}

}  // namespace

Scene load_scene(const Path& path, const ImportOptions& options) {
  ImportOptions own = options;
  own.default_light = options.default_light && options.environment.empty();
  Scene scene = read_any(path, own);
  if (!options.environment.empty())
    scene.environment = environment_of(read_file(options.environment, std::min(kLargestFile, options.most_bytes)),
                                       display(options.environment), Rgb(float(options.environment_scale)),
                                       float(options.environment_rotation), scene.warnings);
  if (!options.normals.empty()) renew_normals(scene, options);
  return scene;
}

}  // namespace aktina
