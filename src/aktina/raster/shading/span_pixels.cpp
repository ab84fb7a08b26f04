#include "aktina/raster/shading/span_pixels.h"

#include <algorithm>

namespace aktina {
namespace {

/// Barycentric coordinates of corners 1 and 2 along a scanline, on the screen.
struct OnLine {
  double b1, b2, step1, step2;  // at the first pixel's centre; from pixel to pixel

  OnLine(const Vec2d (&s)[3], double x, double y) {
    const Vec2d e1 = s[1] - s[0], e2 = s[2] - s[0], p = Vec2d(x, y) - s[0];
    const double area = e1.x * e2.y - e1.y * e2.x;
    if (area == 0) {
      b1 = b2 = 1.0 / 3, step1 = step2 = 0;
      return;
    }
    b1 = (p.x * e2.y - p.y * e2.x) / area, step1 = e2.y / area;
    b2 = (e1.x * p.y - e1.y * p.x) / area, step2 = -e1.y / area;
  }
};

void place_pixels(const OnLine& line, const float (&weight)[3], int first, SpanPixels& out) {
  for (int i = 0; i < out.count; ++i) {
    const double along = first + i;
    const auto s1 = float(line.b1 + along * line.step1), s2 = float(line.b2 + along * line.step2);
    const float w0 = (1 - s1 - s2) * weight[0], w1 = s1 * weight[1], w2 = s2 * weight[2];
    const float sum = w0 + w1 + w2, scale = 1 / sum;
    if (i == 0) out.weight[0] = sum;
    out.weight[1] = sum;
    out.b1[i] = w1 * scale, out.b2[i] = w2 * scale;
  }
  for (size_t i = size_t(out.count); i < padded(size_t(out.count)); ++i)
    out.b1[i] = out.b1[out.count - 1], out.b2[i] = out.b2[out.count - 1];
}

}  // namespace

CornerValues::CornerValues(const TriangleGroup& t, int lane) {
  const auto i = size_t(lane);
  for (int v = 0; v < 3; ++v) {
    position[v] = {t.position[v][0][i], t.position[v][1][i], t.position[v][2][i]};
    normal[v] = {t.normal[v][0][i], t.normal[v][1][i], t.normal[v][2][i]};
    light[v].diffuse = {t.radiance[v][0][i], t.radiance[v][1][i], t.radiance[v][2][i]};
    light[v].specular = {t.radiance[v][3][i], t.radiance[v][4][i], t.radiance[v][5][i]};
  }
}

void SpanPixels::linear(float at0, float at1, float at2, float* out) const {
  const float d1 = at1 - at0, d2 = at2 - at0;
  for (size_t i = 0; i < padded(size_t(count)); ++i) out[i] = at0 + d1 * b1[i] + d2 * b2[i];
}

void visit_pixels(const TriangleGroup& t, int lane, std::span<const Span> spans,
                  FunctionRef<void(const SpanPixels&)> visit) {
  const auto i = size_t(lane);
  Vec2d screen[3];
  for (int v = 0; v < 3; ++v) screen[v] = {t.screen[v][0][i], t.screen[v][1][i]};
  const float weight[3] = {t.weight[0][i], t.weight[1][i], t.weight[2][i]};
  SpanPixels pixels;
  for (const Span& span : spans) {
    const OnLine line(screen, span.first + 0.5, double(span.y));
    for (int first = 0; first < span.count; first += SpanPixels::kMost) {
      pixels.count = std::min(span.count - first, SpanPixels::kMost);
      pixels.output = span.output + size_t(first);
      place_pixels(line, weight, first, pixels);
      visit(pixels);
    }
  }
}

void shade_linear(const CornerValues& c, const SpanPixels& pixels, bool specular, const LitArrays& out) {
  for (int k = 0; k < 3; ++k) {
    pixels.linear(c.light[0].diffuse[k], c.light[1].diffuse[k], c.light[2].diffuse[k], out.diffuse[k] + pixels.output);
    float* const to = out.specular[k] + pixels.output;
    if (specular) {
      pixels.linear(c.light[0].specular[k], c.light[1].specular[k], c.light[2].specular[k], to);
    } else {
      std::fill_n(to, padded(size_t(pixels.count)), 0.0f);
    }
  }
}

void shade_highlights(const CornerValues& c, const SpanPixels& pixels, int first, int count, const Illuminator& light,
                      const LitArrays& out) {
  alignas(64) float position[3][SpanPixels::kMost], normal[3][SpanPixels::kMost], diffuse[3][SpanPixels::kMost];
  LitArrays to;
  for (int k = 0; k < 3; ++k) {
    pixels.linear(c.position[0][k], c.position[1][k], c.position[2][k], position[k]);
    pixels.linear(c.normal[0][k], c.normal[1][k], c.normal[2][k], normal[k]);
    to.diffuse[k] = diffuse[k], to.specular[k] = out.specular[k] + pixels.output + first;
  }
  light.evaluate({size_t(count),
                  {position[0] + first, position[1] + first, position[2] + first},
                  {normal[0] + first, normal[1] + first, normal[2] + first}},
                 to);
}

}  // namespace aktina
