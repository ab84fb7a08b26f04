// What the surface is made of at each texel of a lightmap.
#pragma once

#include <span>
#include <vector>

#include "aktina/radiosity/lightmap/coverage.h"

namespace aktina {

struct TexelMaterials {
  std::vector<Rgb> reflectances;    // by texel: matt_reflectance(), textures and vertex colours applied
  std::vector<Radiance> emissions;  // by texel
};

/// Means of four places in each texel. @param scene  without analytic primitives
TexelMaterials texel_materials(const Scene& scene, const LightmapLayout& layout, std::span<const LightmapTexel> texels);

}  // namespace aktina
