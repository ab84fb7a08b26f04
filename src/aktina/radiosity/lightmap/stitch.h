// Seams: edges of surfaces that stand in two places of a lightmap.
#pragma once

#include "aktina/image/image.h"
#include "aktina/radiosity/lightmap/layout.h"

namespace aktina {

struct SeamReport {
  uint64_t samples = 0;          // points at which both sides were compared, about one a texel
  double before = 0, after = 0;  // root mean square of the differences over the mean of the values
};

/// Changes texels at seams so that what a viewer interpolates on both sides agrees: within charts of one surface and
/// across surfaces and objects, wherever two edges stand in one place, end at the same points, and normals go on
/// smoothly. Least squares: differences at the seams against changes of texels, those that no chart touches for free;
/// by conjugate gradients.
/// M. Iwanicki, "Lighting Technology of The Last of Us", SIGGRAPH 2013 Talks.
/// @param known  by page and texel: touched by a chart
SeamReport stitch(const LightmapLayout& layout, const std::vector<std::vector<uint8_t>>& known,
                  std::vector<Image>& pages);

}  // namespace aktina
