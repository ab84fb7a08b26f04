#include "aktina/raster/shading/span.h"

#include <algorithm>

namespace aktina {
namespace {

Vec3 vertex(const Lanes (&values)[3][3], int v, int lane) {
  const auto i = size_t(lane);
  return {values[v][0][i], values[v][1][i], values[v][2][i]};
}

}  // namespace

Span span_at(const Vec2 (&screen)[3], float y) {
  Span span{};
  span.y = y, span.left.x = kInfinity, span.right.x = -kInfinity;
  for (int from = 0; from < 3; ++from) {
    const int to = (from + 1) % 3;
    const Vec2 a = screen[from], b = screen[to];
    if (a.y == b.y || !(std::min(a.y, b.y) <= y && y <= std::max(a.y, b.y))) continue;
    const float t = (y - a.y) / (b.y - a.y);
    const Span::End end{from, to, t, a.x + t * (b.x - a.x)};
    if (end.x < span.left.x) span.left = end;
    if (end.x > span.right.x) span.right = end;
  }
  return span;
}

SpanEnds::SpanEnds(const TriangleGroup& triangles, int lane, std::span<const Span> spans, NormalBetween between) {
  for (size_t i = 0; i < kLanes; ++i) {
    const Span& span = spans[std::min(i / 2, spans.size() - 1)];
    const Span::End& end = i % 2 == 0 ? span.left : span.right;
    const float from = (1 - end.t) * triangles.weight[end.from][size_t(lane)];
    const float to = end.t * triangles.weight[end.to][size_t(lane)];
    weight[i] = from + to;
    const float s = to / weight[i];  // share of vertex `to` on the surface
    const auto at = [&](const Lanes(&values)[3][3], int v) { return vertex(values, v, lane); };
    const Point3 p = linear(at(triangles.position, end.from), at(triangles.position, end.to), s);
    const Vec3 n = between(at(triangles.normal, end.from), at(triangles.normal, end.to), s);
    for (int k = 0; k < 3; ++k) position[k][i] = p[k], normal[k][i] = n[k];
  }
}

}  // namespace aktina
