// A solution -> lightmaps: the stages in their order.
#include "aktina/radiosity/lightmap/lightmap.h"

#include "aktina/radiosity/display/patch_scene.h"
#include "aktina/radiosity/lightmap/denoise.h"
#include "aktina/radiosity/lightmap/stitch.h"
#include "aktina/radiosity/lightmap/texel_light.h"
#include "aktina/scene/tessellate.h"

namespace aktina {

Lightmap make_lightmap(const Scene& scene, const Solution& solution, const LightmapOptions& options,
                       Progress* progress) {
  const TessellatedScene tessellated(scene);
  check_places(*tessellated, solution);
  if (progress) progress->begin("charts", "charts", 0);
  Lightmap map;
  map.layout = make_layout(lightmap_surfaces(*tessellated, solution), options);
  map.texels = covered_texels(map.layout);
  TexelLight light = light_on_texels(*tessellated, solution, map.layout, map.texels, options, progress);
  if (!light.buried.empty()) replace_useless(map.layout, map.texels, light.buried, light.irradiances);
  denoise(map.layout, map.texels, light);
  map.irradiances = texel_pages(map.layout, map.texels, light.irradiances);
  std::vector<std::vector<uint8_t>> touched;
  for (const LightmapLayout::Page& page : map.layout.pages)
    touched.emplace_back(size_t(page.width) * size_t(page.height));
  for (const LightmapTexel& t : map.texels) {
    const int page = map.layout.charts[t.chart].page;
    touched[size_t(page)][t.y * size_t(map.layout.pages[size_t(page)].width) + t.x] = 1;
  }
  map.seams = stitch(map.layout, touched, map.irradiances);
  return map;
}

std::vector<Image> texel_pages(const LightmapLayout& layout, std::span<const LightmapTexel> texels,
                               std::span<const Rgb> values) {
  std::vector<Image> pages;
  std::vector<std::vector<uint8_t>> known;
  for (const LightmapLayout::Page& page : layout.pages) {
    pages.emplace_back(page.width, page.height, 3);
    known.emplace_back(size_t(page.width) * size_t(page.height));
  }
  for (size_t i = 0; i < texels.size(); ++i) {
    const auto page = size_t(layout.charts[texels[i].chart].page);
    pages[page].set_rgb(int(texels[i].x), int(texels[i].y), values[i]);
    known[page][texels[i].y * size_t(pages[page].width) + texels[i].x] = 1;
  }
  for (size_t p = 0; p < pages.size(); ++p) spread(pages[p], std::move(known[p]));
  return pages;
}

}  // namespace aktina
