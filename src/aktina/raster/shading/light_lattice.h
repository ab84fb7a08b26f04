// The illumination model at the lattice points of triangles: the set-up of polynomial shading.
#pragma once

#include "aktina/raster/shading/shading_method.h"

namespace aktina {

/// Values of a colour polynomial: corners as they are in `triangles.radiance`, the other points lit with the normalised
/// mean of the corners' normals there. Both triangles of an edge get the same values on it.
/// @pre  plan.needs holds kPosition, kNormal, kRadiance and kScreen
void light_lattice(const TriangleGroup& triangles, const Illuminator& light, const ShadingPlan& plan,
                   const Samples& out);

/// A method that is nothing but that: a polynomial of the given degree through lit points.
std::unique_ptr<ShadingMethod> polynomial_shading(int degree, bool perspective);

}  // namespace aktina
