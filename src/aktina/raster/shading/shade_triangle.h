// One triangle, shaded at given points: what the rasterizer does for a frame, in its readable form.
#pragma once

#include <span>
#include <vector>

#include "aktina/raster/shading/shading_method.h"

namespace aktina {

/// Values of the Lagrange polynomials of a lattice: of degree 0 to 3, in lattice()'s order. They sum to 1; the one of a
/// lattice point is 1 there and 0 at the others.
/// @param weights  as many as the lattice has points
void lagrange(int degree, Vec3 barycentric, std::span<float> weights);

struct ShadedTriangle {
  Point3 position[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};  // m, world
  Vec3 normal[3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};      // unit
  Vec2 screen[3] = {{0, 0}, {0, 1}, {1, 0}};               // px, y downwards
  float weight[3] = {1, 1, 1};                             // 1 / w of the perspective division
};

/// Light towards the viewer at points of a triangle, cd/m^2.
/// @param barycentric  on the screen, each summing to 1, within the triangle
/// @throws Error bad_param (a triangle without area on the screen, for methods that need spans)
std::vector<Lit> shade(const ShadingMethod& method, const Illuminator& light, const ShadedTriangle& triangle,
                       std::span<const Vec3> barycentric);

}  // namespace aktina
