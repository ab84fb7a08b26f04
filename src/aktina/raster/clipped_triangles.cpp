#include "aktina/raster/clipped_triangles.h"

#include <algorithm>

namespace aktina {
namespace {

/// Twice the signed area on the screen, y running down: negative for triangles seen from the front.
int64_t twice_area(const std::array<ScreenVertex, 3>& s) {
  return int64_t(s[1].x - s[0].x) * (s[2].y - s[0].y) - int64_t(s[2].x - s[0].x) * (s[1].y - s[0].y);
}

bool meets_pixels(const std::array<ScreenVertex, 3>& s, const View& view) {
  const auto [x0, x1] = std::minmax({s[0].x, s[1].x, s[2].x});
  const auto [y0, y1] = std::minmax({s[0].y, s[1].y, s[2].y});
  const PixelRange columns = pixel_range(x0, x1, view.width()), rows = pixel_range(y0, y1, view.height());
  return columns.first <= columns.last && rows.first <= rows.last;
}

/// The last valid lane again in those that are empty.
void pad(CornerGroup& g) {
  const auto last = size_t(g.count - 1);
  for (auto i = size_t(g.count); i < kLanes; ++i) {
    for (int k = 0; k < 3; ++k) {
      g.x[k][i] = g.x[k][last], g.y[k][i] = g.y[k][last], g.depth[k][i] = g.depth[k][last];
      g.vertex[k][i] = g.vertex[k][last];
      for (int v = 0; v < 3; ++v) g.barycentric[k][v][i] = g.barycentric[k][v][last];
    }
    g.triangle[i] = g.triangle[last], g.side[i] = g.side[last];
  }
}

}  // namespace

void ClippedTriangles::draw(uint32_t first, uint32_t lanes, Emit emit) {
  for (uint32_t i = 0; i < kLanes; ++i)
    if (lanes >> i & 1) cut(first + i, emit);
  flush(emit);
}

void ClippedTriangles::cut(uint32_t triangle, Emit emit) {
  std::array<Vec4, 3> clip;
  for (int k = 0; k < 3; ++k)
    clip[size_t(k)] = view_.clip_from_world() * Vec4(list_.position_of(list_.index(k)[triangle]), 1);
  std::array<ClipVertex, kMostClippedVertices> polygon;
  const int corners = clipper_.clip(clip, polygon);
  for (int k = 0; k < corners; ++k)
    if (!is_finite(Vec3(polygon[size_t(k)].clip))) return;  // from a vertex that is not, or too far away
  for (int k = 2; k < corners; ++k) add(triangle, {&polygon[0], &polygon[size_t(k - 1)], &polygon[size_t(k)]}, emit);
}

/// A corner that is a vertex stays where its other triangles have it.
ScreenVertex ClippedTriangles::place(uint32_t triangle, const ClipVertex& corner) const {
  for (int k = 0; k < 3; ++k) {
    const uint32_t v = list_.index(k)[triangle];
    const ScreenPoint& p = screen_[v];
    if (corner.barycentric[k] == 1 && !p.to_be_clipped()) return {p.x, p.y, p.depth, view_.perspective() ? p.depth : 1};
  }
  return view_.project(corner.clip);
}

void ClippedTriangles::add(uint32_t triangle, const std::array<const ClipVertex*, 3>& corners, Emit emit) {
  const std::array<ScreenVertex, 3> s = {place(triangle, *corners[0]), place(triangle, *corners[1]),
                                         place(triangle, *corners[2])};
  const int64_t area = twice_area(s);
  const bool front = area < 0;
  if (area == 0 || (cull_ && !front) || !meets_pixels(s, view_)) return;
  const auto lane = size_t(group_.count++);
  for (size_t k = 0; k < 3; ++k) {
    const size_t from = front ? k : (3 - k) % 3;
    group_.x[k][lane] = s[from].x, group_.y[k][lane] = s[from].y, group_.depth[k][lane] = s[from].depth;
    group_.vertex[k][lane] = list_.index(int(k))[triangle];
    for (int v = 0; v < 3; ++v) group_.barycentric[k][v][lane] = corners[from]->barycentric[v];
  }
  group_.triangle[lane] = triangle;
  group_.side[lane] = front ? 1 : -1;
  if (group_.count == int(kLanes)) flush(emit);
}

void ClippedTriangles::flush(Emit emit) {
  if (group_.count == 0) return;
  pad(group_);
  emit(group_);
  group_.count = 0;
}

}  // namespace aktina
