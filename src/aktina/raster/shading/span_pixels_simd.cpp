// Where the pixels of spans are on their triangle.
#include <algorithm>

#include "aktina/raster/shading/span_pixels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/shading/span_pixels_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/base/simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
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

/// Appends `count` pixels of a scanline.
HWY_INLINE void place_run(const OnLine& line, const float (&weight)[3], int count, SpanPixels& out) {
  const F b1 = set(float(line.b1)), b2 = set(float(line.b2)), last = set(float(count - 1));
  const F step1 = set(float(line.step1)), step2 = set(float(line.step2));
  SpanPixels::Run& run = out.runs[out.run_count++];
  run.begin = out.count, run.count = count;
  for (size_t i = 0; i < padded(size_t(count)); i += kPart) {
    const F along = hn::Min(hn::Iota(kFloat, float(i)), last);
    const F s1 = fma(along, step1, b1), s2 = fma(along, step2, b2);
    const F w1 = s1 * set(weight[1]), w2 = s2 * set(weight[2]);
    const F w0 = (set(1.0f) - s1 - s2) * set(weight[0]), scale = set(1.0f) / (w0 + w1 + w2);
    store(w1 * scale, out.b1 + out.count + i), store(w2 * scale, out.b2 + out.count + i);
  }
  const auto sum = [&](double i) {
    const auto s1 = float(line.b1 + i * line.step1), s2 = float(line.b2 + i * line.step2);
    return (1 - s1 - s2) * weight[0] + s1 * weight[1] + s2 * weight[2];
  };
  run.weight[0] = sum(0), run.weight[1] = sum(count - 1);
  out.count += int(padded(size_t(count)));
}

void VisitPixels(const TriangleGroup& t, int lane, std::span<const Span> spans,
                 FunctionRef<void(const SpanPixels&)> visit) {
  const auto i = size_t(lane);
  Vec2d screen[3];
  for (int v = 0; v < 3; ++v) screen[v] = {t.screen[v][0][i], t.screen[v][1][i]};
  const float weight[3] = {t.weight[0][i], t.weight[1][i], t.weight[2][i]};
  SpanPixels pixels;
  pixels.count = 0;
  for (const Span& span : spans)
    for (int first = 0; first < span.count; first += SpanPixels::kMost) {
      const int count = std::min(span.count - first, SpanPixels::kMost);
      const size_t output = span.output + size_t(first);
      const bool follows = pixels.output + size_t(pixels.count) == output;
      if (pixels.count > 0 && (!follows || pixels.count + int(padded(size_t(count))) > SpanPixels::kMost)) {
        visit(pixels);
        pixels.count = 0;
      }
      if (pixels.count == 0) pixels.output = output, pixels.run_count = 0;
      place_run(OnLine(screen, span.first + first + 0.5, double(span.y)), weight, count, pixels);
    }
  if (pixels.count > 0) visit(pixels);
}

void LinearValues(const SpanPixels& pixels, float at0, float at1, float at2, int begin, int end, float* out) {
  const F v0 = set(at0), d1 = set(at1 - at0), d2 = set(at2 - at0);
  for (size_t i = size_t(begin); i < size_t(end); i += kPart)
    store(fma(load(pixels.b1 + i), d1, fma(load(pixels.b2 + i), d2, v0)), out + i);
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(VisitPixels);
HWY_EXPORT(LinearValues);

void visit_pixels(const TriangleGroup& triangles, int lane, std::span<const Span> spans,
                  FunctionRef<void(const SpanPixels&)> visit) {
  HWY_DYNAMIC_DISPATCH(VisitPixels)(triangles, lane, spans, visit);
}

void SpanPixels::linear(float at0, float at1, float at2, int begin, int end, float* out) const {
  HWY_DYNAMIC_DISPATCH(LinearValues)(*this, at0, at1, at2, begin, end, out);
}

}  // namespace aktina
#endif
