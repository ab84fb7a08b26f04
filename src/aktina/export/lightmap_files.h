// Lightmaps -> files that viewers open.
#pragma once

#include <optional>
#include <string_view>

#include "aktina/export/export.h"
#include "aktina/radiosity/lightmap/lightmap.h"

namespace aktina {

/// How a glTF file carries a lightmap.
enum class LightmapForm {
  emissive,  // black materials that shine with what the surfaces reflect: any viewer shows it
  lightmap,  // materials as they are, with MOZ_lightmap: for viewers that know it
};

/// .glb or .gltf by the extension. Texture coordinates of the lightmap are TEXCOORD_1; pages are PNG files in it.
///   emissive:  emissiveTexture = sRGB code of exposure * radiance, at most 1; KHR_materials_emissive_strength where a
///              surface shines brighter by itself. Base textures are in it, as fine as its texels.
///   lightmap:  MOZ_lightmap = exposure * H / pi, linear, at most 1, with intensity pi: a viewer multiplies exposed
///              irradiance by base / pi. Emission is exposed. The punctual lights are in the map: their intensity is 0,
///              that of the scene stands in their extras.aktina.intensity.
/// Names, hierarchy and cameras are kept, and the original materials stand behind, named in extras.
/// @throws Error io; unsupported (a material whose textures use both sets of texture coordinates)
void write_lightmapped_gltf(const Path& path, const Scene& scene, const Solution& solution, const Lightmap& lightmap,
                            LightmapForm form, const LitGltfOptions& options = {});

/// Irradiance in lux, linear float, one EXR file a page: `path`, then NAME.1.exr, NAME.2.exr, ... beside it.
/// @return  the files. @throws Error io
std::vector<Path> write_lightmap_pictures(const Path& path, const Lightmap& lightmap, const Metadata& metadata = {});

}  // namespace aktina
