// Charts: parts of a surface, laid flat.
#pragma once

#include <cstdint>
#include <vector>

#include "aktina/radiosity/lightmap/flat_overlap.h"
#include "aktina/radiosity/lightmap/surface.h"

namespace aktina {

struct Chart {
  std::vector<uint32_t> triangles;    // of the surface
  std::vector<FlatTriangle> corners;  // m, of each of them, in their order; from 0 to `size`
  Vec2 size{0};                       // m
};

/// Normals of a chart's triangles are within this cosine of its axis: lengths shrink by no more than that.
inline constexpr float kLeastChartCosine = 0.75f;

/// Cuts a surface into charts: from the largest triangle that has none, neighbours are added that face about the same
/// way and go on smoothly (edges where normals part are borders of charts, as light jumps there); then all are laid
/// into the plane that they face on average. No triangle of a chart lies upon another. Each chart is turned to be a
/// small rectangle, wider than high.
/// After B. Levy, S. Petitjean, N. Ray, J. Maillot, "Least Squares Conformal Maps for Automatic Texture Atlas
/// Generation", SIGGRAPH 2002 (growing charts), and D. Cohen-Steiner, P. Alliez, M. Desbrun, "Variational Shape
/// Approximation", SIGGRAPH 2004 (their planes).
std::vector<Chart> make_charts(const LightmapSurface& surface);

/// Moves the chart to 0 and fills its size.
void settle(Chart& chart);
/// Turns it so that the rectangle around it is small and no higher than wide; and settles it.
void turn_to_small_rectangle(Chart& chart);

}  // namespace aktina
