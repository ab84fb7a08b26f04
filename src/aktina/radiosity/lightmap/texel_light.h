// The light that arrives at each texel of a lightmap.
#pragma once

#include <span>
#include <vector>

#include "aktina/base/progress.h"
#include "aktina/radiosity/lightmap/coverage.h"
#include "aktina/radiosity/solution.h"

namespace aktina {

struct TexelLight {
  std::vector<Rgb> irradiances;  // by texel, lx
  std::vector<float> variances;  // by texel, of the irradiance's luminance, lx^2; empty: nothing was sampled
  std::vector<uint8_t> buried;   // by texel: it lies within a body, so that its light is of no use; empty: not known
  bool useless(size_t texel) const { return !buried.empty() && buried[texel]; }
};

/// @param scene  without analytic primitives. The same values for any number of threads. @throws Error cancelled
TexelLight light_on_texels(const Scene& scene, const Solution& solution, const LightmapLayout& layout,
                           std::span<const LightmapTexel> texels, const LightmapOptions& options, Progress* progress);

/// A place on a chart's triangle, in world space.
struct TexelPoint {
  Point3 position;  // on the surface
  Vec3 facing;      // unit geometric normal, of the chart's side
  Vec3 normal;      // unit shading normal
};
TexelPoint texel_point(const LightmapLayout& layout, const LightmapTexel& texel, Vec2 uv);

}  // namespace aktina
