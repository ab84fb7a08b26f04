#include "aktina/raster/shading/span_pixels.h"

#include <algorithm>

namespace aktina {

CornerValues::CornerValues(const TriangleGroup& t, int lane) {
  const auto i = size_t(lane);
  for (int v = 0; v < 3; ++v) {
    position[v] = {t.position[v][0][i], t.position[v][1][i], t.position[v][2][i]};
    normal[v] = {t.normal[v][0][i], t.normal[v][1][i], t.normal[v][2][i]};
    light[v].diffuse = {t.radiance[v][0][i], t.radiance[v][1][i], t.radiance[v][2][i]};
    light[v].specular = {t.radiance[v][3][i], t.radiance[v][4][i], t.radiance[v][5][i]};
  }
}

void shade_linear(const CornerValues& c, const SpanPixels& pixels, bool specular, const LitArrays& out) {
  for (int k = 0; k < 3; ++k) {
    const auto& [c0, c1, c2] = c.light;
    pixels.linear(c0.diffuse[k], c1.diffuse[k], c2.diffuse[k], 0, pixels.count, out.diffuse[k] + pixels.output);
    float* const to = out.specular[k] + pixels.output;
    if (specular) {
      pixels.linear(c0.specular[k], c1.specular[k], c2.specular[k], 0, pixels.count, to);
    } else {
      std::fill_n(to, pixels.count, 0.0f);
    }
  }
}

void shade_highlights(const CornerValues& c, const SpanPixels& pixels, int begin, int end, const Illuminator& light,
                      const LitArrays& out) {
  alignas(64) float position[3][SpanPixels::kMost], normal[3][SpanPixels::kMost], diffuse[3][SpanPixels::kMost];
  const float *from[3], *across[3];
  LitArrays to;
  for (int k = 0; k < 3; ++k) {
    pixels.linear(c.position[0][k], c.position[1][k], c.position[2][k], begin, end, position[k]);
    pixels.linear(c.normal[0][k], c.normal[1][k], c.normal[2][k], begin, end, normal[k]);
    from[k] = position[k] + begin, across[k] = normal[k] + begin;
    to.diffuse[k] = diffuse[k], to.specular[k] = out.specular[k] + pixels.output + begin;
  }
  light.evaluate({size_t(end - begin), {from[0], from[1], from[2]}, {across[0], across[1], across[2]}}, to);
}

}  // namespace aktina
