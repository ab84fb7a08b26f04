// Spans of triangles on scanlines, and what methods read at their ends.
#pragma once

#include <algorithm>

#include "aktina/raster/shading/shading_method.h"

namespace aktina {

/// The span of a triangle on the line at y (px): `first`, `count` and `output` are 0. Where the line does not meet it,
/// left.x > right.x.
Span span_at(const Vec2 (&screen)[3], float y);

/// A normal between two unit ones, of any length.
using NormalBetween = Vec3 (*)(Vec3 a, Vec3 b, float t);
inline Vec3 linear(Vec3 a, Vec3 b, float t) { return (1 - t) * a + t * b; }

/// Eight spans with their sixteen ends, those of span i at 2 i and 2 i + 1. Ends beyond the last span are copies of it.
struct SpanEnds {
  static constexpr size_t kSpans = kLanes / 2;
  Lanes position[3], normal[3];  // m, world; not unit; both perspective-correct
  Lanes weight;                  // 1 / w of the perspective division

  /// @param spans  1 to 8
  SpanEnds(const TriangleGroup& triangles, int lane, std::span<const Span> spans, NormalBetween between = linear);
  Point3 position_of(size_t end) const { return {position[0][end], position[1][end], position[2][end]}; }
  Vec3 normal_of(size_t end) const { return {normal[0][end], normal[1][end], normal[2][end]}; }
};

/// Calls body(some, ends) for all spans, eight at a time: some of them, and their ends.
template <class Body>
void for_span_ends(const TriangleGroup& triangles, int lane, std::span<const Span> spans, NormalBetween between,
                   Body&& body) {
  for (; !spans.empty(); spans = spans.subspan(std::min(SpanEnds::kSpans, spans.size()))) {
    const auto some = spans.first(std::min(SpanEnds::kSpans, spans.size()));
    body(some, SpanEnds(triangles, lane, some, between));
  }
}

/// Where pixel centres are along a span: t = start + i step for pixel i; within 0 .. 1 where centres are within.
struct SpanSteps {
  float start, step;
  explicit SpanSteps(const Span& span) {
    const float width = span.right.x - span.left.x;
    step = width > 0 ? 1 / width : 0;
    start = (float(span.first) + 0.5f - span.left.x) * step;
  }
};

/// Writes what is linear along a span. @param left, right  six channels: diffuse, specular
void fill_linear(const Span& span, const float (&left)[6], const float (&right)[6], const LitArrays& out);

}  // namespace aktina
