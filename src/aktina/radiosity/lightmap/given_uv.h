// Second texture coordinates that a file brings along: whether they can be used as those of a lightmap.
#pragma once

#include "aktina/base/warnings.h"
#include "aktina/radiosity/lightmap/chart.h"

namespace aktina {

/// All of the surface as one chart, its coordinates stretched to the surface's area. Empty, and the reason in
/// `warnings`, where they leave [0, 1], overlap, or give a triangle no area.
Chart given_chart(const LightmapSurface& surface, Warnings& warnings);

/// Whether all surfaces' coordinates together lie in the unit square without overlap: one page, made for them.
bool share_a_page(const std::vector<LightmapSurface>& surfaces);

}  // namespace aktina
