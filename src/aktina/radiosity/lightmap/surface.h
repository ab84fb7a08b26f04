// What gets a place in a lightmap: one side of an instance, its triangles in world space.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "aktina/radiosity/solution.h"
#include "aktina/scene/scene.h"

namespace aktina {

struct LightmapSurface {
  uint32_t instance = 0;
  bool back = false;  // of a two-sided one

  // By triangle; those without area are left out.
  std::vector<uint32_t> sources;                // triangles of the instance's mesh
  std::vector<std::array<uint32_t, 3>> places;  // corners in one place have one number
  std::vector<std::array<Point3, 3>> corners;   // m, world, in the order of the mesh
  std::vector<std::array<Vec3, 3>> normals;     // unit shading normals at the corners, world, of this side
  std::vector<Vec3> facing;                     // unit geometric normal of this side
  std::vector<float> areas;                     // m^2
  std::vector<std::array<Vec2, 3>> given;       // second texture coordinates; empty: none

  size_t size() const { return sources.size(); }
  double area() const {
    double sum = 0;
    for (const float a : areas) sum += double(a);
    return sum;
  }
};

/// The surfaces of all instances on which the solution has patches: fronts, and backs of what is two-sided.
/// @param scene  without analytic primitives
std::vector<LightmapSurface> lightmap_surfaces(const Scene& scene, const Solution& solution);

}  // namespace aktina
