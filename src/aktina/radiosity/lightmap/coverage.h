// Which texels a lightmap's charts touch, and where on the surface each of them lies.
#pragma once

#include <span>
#include <vector>

#include "aktina/radiosity/lightmap/layout.h"

namespace aktina {

/// A texel that a chart touches, and the point of the chart next to its middle.
struct LightmapTexel {
  uint32_t chart, triangle;  // of the layout; of the chart
  uint32_t x, y;             // on the chart's page
  float u, v;                // barycentric, of corners 1 and 2 of the triangle
};

/// Conservative: all texels whose square is touched. Page by page, row by row. Cost: linear in texels and in triangles.
std::vector<LightmapTexel> covered_texels(const LightmapLayout& layout);

/// Barycentric coordinates (u, v) of the point of a triangle next to p.
Vec2 nearest_on_triangle(const FlatTriangle& t, Vec2 p);

/// Gives texels without a value the mean of their neighbours that have one, in rounds from the charts outwards, until
/// all have one.
/// @param known  by texel: has a value
void spread(Image& image, std::vector<uint8_t> known);

/// The same within charts, for texels whose own value is of no use: they take it from others of their chart. A chart
/// without any useful value keeps those that it has.
/// @param useless  by texel
void replace_useless(const LightmapLayout& layout, std::span<const LightmapTexel> texels,
                     const std::vector<uint8_t>& useless, std::vector<Rgb>& values);

}  // namespace aktina
