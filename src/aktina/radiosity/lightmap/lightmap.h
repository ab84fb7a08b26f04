// Lightmaps: the light on surfaces as pictures, for viewers that compute none.
#pragma once

#include <span>
#include <vector>

#include "aktina/base/progress.h"
#include "aktina/image/image.h"
#include "aktina/radiosity/lightmap/coverage.h"
#include "aktina/radiosity/lightmap/stitch.h"
#include "aktina/radiosity/solution.h"
#include "aktina/scene/scene.h"

namespace aktina {

struct Lightmap {
  LightmapLayout layout;
  std::vector<LightmapTexel> texels;  // page by page, row by row
  /// Irradiance H, lx, linear, by page. What no chart touches has the values that lie next to it.
  std::vector<Image> irradiances;
  SeamReport seams;
};

/// Light by texel: as the solution has it at its vertices, in between linear; with `direct_samples`, lamps and emitters
/// by shadow rays instead of the solution's direct light, with `gather_samples` all other light by rays that see the
/// solution (final gather). What is noisy is smoothed within charts, values on both sides of seams are made equal.
/// The same bytes for any number of threads. @throws Error bad_param, limit (says what would fit), cancelled, usage
Lightmap make_lightmap(const Scene& scene, const Solution& solution, const LightmapOptions& options = {},
                       Progress* progress = nullptr);

/// Values of texels as pictures; what no chart touches has the values that lie next to it.
std::vector<Image> texel_pages(const LightmapLayout& layout, std::span<const LightmapTexel> texels,
                               std::span<const Rgb> values);

/// The scene as the lightmap has it: for each chart's surface and page one instance, vertices doubled where charts
/// part, second texture coordinates are places on the page. Two-sided surfaces become two layers. Other attributes,
/// materials, nodes, cameras and lights as they are, but for textures on the second coordinates: they move to the
/// first.
/// @throws Error unsupported (a material whose textures use both)
struct LightmappedScene {
  Scene scene;
  // By instance.
  std::vector<int> pages;
  std::vector<uint8_t> backs;     // it is the back of a two-sided one
  std::vector<uint32_t> sources;  // the instance of the (tessellated) scene that it is of
};
LightmappedScene lightmapped_scene(const Scene& scene, const Lightmap& lightmap);

}  // namespace aktina
