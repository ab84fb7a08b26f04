// Methods that interpolate normals quadratically: they differ in the normal they put in the middle of an edge.
#pragma once

#include "aktina/raster/shading/shading_method.h"

namespace aktina {

/// Normal in the middle of an edge from p0 to p1 whose ends have unit normals n0 and n1; of any length.
using EdgeNormal = Vec3 (*)(Vec3 n0, Vec3 n1, Vec3 edge);

/// Interpolates normals as the quadratic through those of the corners and of the edges' middles, perspective-correct,
/// and evaluates the illumination model at each pixel.
/// @param unit  they are near enough to unit length to be used as they are; else they are made unit again
std::unique_ptr<ShadingMethod> edge_normal_shading(EdgeNormal middle, bool unit);

}  // namespace aktina
