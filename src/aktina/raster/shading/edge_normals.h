// Methods that interpolate normals quadratically: they differ in the normal they put in the middle of an edge.
#pragma once

#include "aktina/raster/shading/shading_method.h"

namespace aktina {

/// Normal in the middle of an edge from p0 to p1 whose ends have unit normals n0 and n1; of any length.
using EdgeNormal = Vec3 (*)(Vec3 n0, Vec3 n1, Vec3 edge);

/// Corners' normals and those of the edges' middles, as samples of a quadratic in channels 0 to 2.
/// @pre  plan.needs holds kPosition and kNormal
void sample_edge_normals(const TriangleGroup& triangles, EdgeNormal middle, const Samples& out);

}  // namespace aktina
