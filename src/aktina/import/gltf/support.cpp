// What a file says that it needs: version and extensions.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "aktina/import/gltf/schema.h"

namespace aktina::gltf {
namespace {

struct Version {
  unsigned major = 0, minor = 0;
};

Version version_of(const Value& value) {
  const std::string_view text = value.text_view();
  Version out;
  const char* end = text.data() + text.size();
  const auto major = std::from_chars(text.data(), end, out.major);
  const bool dot = major.ec == std::errc() && major.ptr != end && *major.ptr == '.';
  const auto minor = dot ? std::from_chars(major.ptr + 1, end, out.minor) : major;
  if (!dot || minor.ec != std::errc() || minor.ptr != end) value.fail("is not a version like 2.0");
  return out;
}

/// Extensions that a picture does not suffer from when they are read as they are.
constexpr std::string_view kRead[] = {"KHR_lights_punctual",
                                      "KHR_materials_emissive_strength",
                                      "KHR_materials_ior",
                                      "KHR_materials_transmission",
                                      "KHR_materials_specular",
                                      "KHR_materials_unlit",
                                      "KHR_materials_pbrSpecularGlossiness",
                                      "KHR_materials_variants",
                                      "KHR_mesh_quantization",
                                      "KHR_node_visibility",
                                      "KHR_texture_transform",
                                      "KHR_draco_mesh_compression",
                                      "KHR_xmp",
                                      "KHR_xmp_json_ld",
                                      "EXT_lights_ies",
                                      "EXT_mesh_gpu_instancing",
                                      "EXT_meshopt_compression",
                                      "EXT_texture_webp"};

bool is_read(const std::string& name) { return std::find(std::begin(kRead), std::end(kRead), name) != std::end(kRead); }

std::set<std::string> texts(const Value& list) {
  std::set<std::string> out;
  for (size_t i = 0; i < list.size(); ++i) out.insert(list[i].text());
  return out;
}

}  // namespace

void check_version(const Value& root, Warnings& warnings) {
  const Value asset = root["asset"];
  const Value least = asset["minVersion"] ? asset["minVersion"] : asset["version"];
  const Version version = version_of(asset["version"]), needed = version_of(least);
  if (version.major != 2 || needed.major != 2 || (asset["minVersion"] && needed.minor > 0))
    least.fail(fmt::format("glTF {} is not read, only 2.0", least.text()), Code::unsupported);
  if (version.minor > 0) warnings.add("the file's version is newer than glTF 2.0: what that adds is left out");
}

void check_extensions(const Value& root, Warnings& warnings) {
  const std::set<std::string> used = texts(root["extensionsUsed"]), required = texts(root["extensionsRequired"]);
  for (const std::string& name : required) {
    if (!is_read(name))
      root["extensionsRequired"].fail("the file needs the extension " + name + ", which Aktina does not read",
                                      Code::unsupported, "export without it");
    if (!used.contains(name)) warnings.add("extensions that are required are not in the list of those used");
  }
  if (used.contains("KHR_mesh_quantization") && !required.contains("KHR_mesh_quantization"))
    warnings.add("KHR_mesh_quantization is used without being required");
  constexpr size_t kMostNamed = 20;  // of a hostile list
  size_t named = 0;
  for (const std::string& name : used)
    if (!is_read(name) && ++named <= kMostNamed)
      warnings.add("the extension " + name + " is not read: what it adds is left out");
}

}  // namespace aktina::gltf
