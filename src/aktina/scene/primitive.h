// Analytic shapes, in their own space. The front is outside (spheres, cylinders, cones) or +y (discs).
#pragma once

#include <variant>

#include "aktina/base/vec.h"
#include "aktina/scene/mesh.h"

namespace aktina {

struct Sphere { float radius = 1; };                                  // m, about the origin
struct Disc { float radius = 1; };                                    // in the plane y = 0
struct Cylinder { float radius = 0.5f, height = 1; };                 // about y, from 0 to height, open
struct Cone { float radius = 0.5f, top_radius = 0, height = 1; };     // about y, from 0 to height, open

using Primitive = std::variant<Sphere, Disc, Cylinder, Cone>;

Bounds bounds(const Primitive& primitive);
double area(const Primitive& primitive);  // m^2, untransformed
/// Triangles on the surface, at most `tolerance` (m) away from it: what the rasterizer and radiosity use.
Mesh tessellate(const Primitive& primitive, float tolerance);

}  // namespace aktina
