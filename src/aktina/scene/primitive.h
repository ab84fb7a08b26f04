// Analytic shapes, in their own space. The front is outside (spheres, cylinders, cones) or +y (discs).
#pragma once

#include <variant>

#include "aktina/base/vec.h"
#include "aktina/scene/mesh.h"

namespace aktina {

/// About the origin.
struct Sphere {
  float radius = 1;  // m
};
/// In the plane y = 0.
struct Disc {
  float radius = 1;  // m
};
/// About y, from 0 to height, without caps.
struct Cylinder {
  float radius = 0.5f, height = 1;  // m
};
/// About y, from 0 to height, without caps.
struct Cone {
  float radius = 0.5f, top_radius = 0, height = 1;  // m
};

using Primitive = std::variant<Sphere, Disc, Cylinder, Cone>;

Bounds bounds(const Primitive& primitive);
double area(const Primitive& primitive);  // m^2, untransformed
/// Triangles on the surface, at most `tolerance` (m) away from it: what the rasterizer and radiosity use.
Mesh tessellate(const Primitive& primitive, float tolerance);

}  // namespace aktina
