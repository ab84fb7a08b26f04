// The steps of write_lit_gltf(), apart from where the light comes from.
#pragma once

#include "aktina/export/export.h"

namespace aktina {

/// The largest factor on H / pi at which vertex colours clip (exceed 1, as glTF forbids) on no more than 1 % of the
/// area. Patches that emit are left out: lamps clip in every picture. 1 where nothing is lit.
float lit_exposure(const Solution& solution);

/// Writes `lit`, whose vertex colours are radiance in cd/m^2 on unlit materials, times `exposure`; the materials of
/// `original` stand behind the unlit ones. Both scenes have the same images.
void write_lit_gltf(const Path& path, const Scene& original, Scene lit, float exposure, const Metadata& metadata);

}  // namespace aktina
