// Solutions -> files that other programs open.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "aktina/base/file.h"
#include "aktina/radiosity/solution.h"
#include "aktina/scene/scene.h"

namespace aktina {

using Metadata = std::vector<std::pair<std::string, std::string>>;

/// The largest factor on H / pi at which vertex colours clip (exceed 1, as glTF forbids) on no more than 1 % of the
/// area. Patches that emit are left out: lamps clip in every picture. 1 where nothing is lit.
float lit_exposure(const Solution& solution);

struct LitGltfOptions {
  float exposure = 0;  // factor on vertex colours; 0: lit_exposure(). Recorded in asset.extras.aktina
  Metadata metadata;   // recorded there too: program, settings, seed, scene, hash
};

/// The scene with its light in vertex colours, .gltf or .glb by the extension: COLOR_0 = exposure * H / pi (linear,
/// float) on KHR_materials_unlit materials that keep their base texture, so that any viewer shows
/// base * H / pi * exposure = exposed radiance. Emissive surfaces get their own radiance. Names, hierarchy, cameras and
/// lights are kept; the original materials stand beside the unlit ones, named in extras.
/// @throws Error io
void write_lit_gltf(const Path& path, const Scene& scene, const Solution& solution, const LitGltfOptions& options = {});

/// VTK XML unstructured grid for ParaView: cells are patches with area, reflectance, emission, irradiance, illuminance,
/// radiosity; points have their smooth values. Appended raw data, little endian. @throws Error io
void write_vtu(const Path& path, const Solution& solution, const Metadata& metadata = {});

/// One line a patch: index, instance, position x y z, normal x y z, area, exitance r g b, irradiance r g b (lx),
/// illuminance (lx, luminance-weighted). @throws Error io
void write_patches_csv(const Path& path, const Scene& scene, const Solution& solution, const Metadata& metadata = {});

}  // namespace aktina
