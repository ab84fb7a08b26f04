// Noise of sampled light on texels, smoothed where there is some.
#pragma once

#include <span>

#include "aktina/radiosity/lightmap/texel_light.h"

namespace aktina {

/// Each sampled texel becomes a mean of those of its chart about it: nearer ones weigh more, and those that face
/// another way or whose value differs by more than noise explains weigh next to nothing, so that edges of shadows stay.
/// Texels without variance keep their value. After H. Dammertz, D. Sewtz, J. Hanika, H. Lensch, "Edge-Avoiding A-Trous
/// Wavelet Transform for fast Global Illumination Filtering", HPG 2010; C. Schied et al., "Spatiotemporal
/// Variance-Guided Filtering", HPG 2017 (weights by variance).
void denoise(const LightmapLayout& layout, std::span<const LightmapTexel> texels, TexelLight& light);

}  // namespace aktina
