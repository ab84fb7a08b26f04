// The steps of write_lit_gltf(), apart from where the light comes from.
#pragma once

#include "aktina/export/export.h"

namespace aktina {

/// Writes `lit`, whose vertex colours are radiance in cd/m^2 on unlit materials, times `exposure`; the materials of
/// `original` stand behind the unlit ones. Both scenes have the same images.
void write_lit_gltf(const Path& path, const Scene& original, Scene lit, float exposure, const Metadata& metadata);

}  // namespace aktina
