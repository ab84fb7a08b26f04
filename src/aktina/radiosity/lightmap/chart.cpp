#include "aktina/radiosity/lightmap/chart.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace aktina {
namespace {

constexpr float kSmooth = 0.9f;  // cosine between normals of one place, as for values at vertices (reconstruct.cpp)
constexpr uint32_t kNone = 0xffffffff;

/// For each edge of each triangle the triangle beyond it, where the surface goes on smoothly.
std::vector<std::array<uint32_t, 3>> smooth_neighbours(const LightmapSurface& s) {
  struct Edge {
    uint32_t low, high, triangle, corner;
    bool operator<(const Edge& o) const {
      return std::tie(low, high, triangle, corner) < std::tie(o.low, o.high, o.triangle, o.corner);
    }
  };
  std::vector<Edge> edges;
  edges.reserve(3 * s.size());
  for (uint32_t t = 0; t < s.size(); ++t)
    for (uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(s.places[t][k], s.places[t][(k + 1) % 3]);
      edges.push_back({low, high, t, k});
    }
  std::sort(edges.begin(), edges.end());
  const auto normal_at = [&](uint32_t triangle, uint32_t place) {
    for (size_t k = 0; k < 3; ++k)
      if (s.places[triangle][k] == place) return s.normals[triangle][k];
    return s.facing[triangle];
  };
  std::vector<std::array<uint32_t, 3>> beyond(s.size(), {kNone, kNone, kNone});
  for (size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    if (end != i + 2) continue;  // a border, or more than two meet
    const Edge &a = edges[i], &b = edges[i + 1];
    bool smooth = true;
    for (const uint32_t place : {a.low, a.high})
      smooth = smooth && dot(normal_at(a.triangle, place), normal_at(b.triangle, place)) > kSmooth;
    if (smooth) beyond[a.triangle][a.corner] = b.triangle, beyond[b.triangle][b.corner] = a.triangle;
  }
  return beyond;
}

class Grower {
 public:
  explicit Grower(const LightmapSurface& s)
      : s_(s), beyond_(smooth_neighbours(s)), taken_(s.size(), false), visited_(s.size(), 0) {}

  std::vector<Chart> run() {
    std::vector<uint32_t> order(s_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return s_.areas[a] > s_.areas[b]; });
    std::vector<Chart> charts;
    for (const uint32_t seed : order)
      if (!taken_[seed]) charts.push_back(from(seed));
    return charts;
  }

 private:
  Chart from(uint32_t seed) {
    std::vector<uint32_t> members = reach(seed, s_.facing[seed]);
    Vec3 sum(0);
    for (const uint32_t t : members) sum += s_.areas[t] * s_.facing[t];
    Vec3 axis = normalize_or(sum, s_.facing[seed]);
    if (dot(axis, s_.facing[seed]) < kLeastChartCosine) axis = s_.facing[seed];
    Chart chart = flat(reach(seed, axis), axis);
    part_overlaps(chart);
    for (const uint32_t t : chart.triangles) taken_[t] = true;
    turn_to_small_rectangle(chart);
    return chart;
  }

  /// Free triangles that can be walked to from the seed and face the axis, nearest first.
  std::vector<uint32_t> reach(uint32_t seed, Vec3 axis) {
    ++round_;
    std::vector<uint32_t> members = {seed};
    visited_[seed] = round_;
    for (size_t i = 0; i < members.size(); ++i)
      for (const uint32_t t : beyond_[members[i]]) {
        if (t == kNone || taken_[t] || visited_[t] == round_ || dot(s_.facing[t], axis) < kLeastChartCosine) continue;
        visited_[t] = round_;
        members.push_back(t);
      }
    return members;
  }

  Chart flat(std::vector<uint32_t> members, Vec3 axis) const {
    const Frame frame(axis);
    const Point3 origin = s_.corners[members[0]][0];
    Chart chart;
    chart.triangles = std::move(members);
    for (const uint32_t t : chart.triangles) {
      FlatTriangle flat;
      for (size_t k = 0; k < 3; ++k) flat[k] = Vec2(frame.to_local(s_.corners[t][k] - origin));
      chart.corners.push_back(flat);
    }
    return chart;
  }

  /// Gives back what lies upon the rest. The seed comes first and stays.
  static void part_overlaps(Chart& chart) {
    for (;;) {
      const FlatOverlap overlap = flat_overlap(chart.corners);
      if (overlap.known && overlap.count == 0) return;
      size_t kept = 0;
      for (size_t i = 0; i < chart.triangles.size(); ++i) {
        if (overlap.known ? bool(overlap.upon[i]) : i >= (chart.triangles.size() + 1) / 2) continue;
        chart.triangles[kept] = chart.triangles[i], chart.corners[kept] = chart.corners[i];
        ++kept;
      }
      chart.triangles.resize(kept), chart.corners.resize(kept);
      if (overlap.known) return;
    }
  }

  const LightmapSurface& s_;
  std::vector<std::array<uint32_t, 3>> beyond_;
  std::vector<bool> taken_;
  std::vector<uint32_t> visited_;
  uint32_t round_ = 0;
};

float turn(Vec2 a, Vec2 b, Vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// A. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information Processing Letters 9, 1979.
std::vector<Vec2> convex_hull(const Chart& chart) {
  std::vector<Vec2> points, hull;
  for (const FlatTriangle& t : chart.corners) points.insert(points.end(), t.begin(), t.end());
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  for (const bool upper : {false, true}) {
    const size_t fixed = hull.size() + 1;
    for (const Vec2 p : points) {
      while (hull.size() > fixed && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    if (!upper) std::reverse(points.begin(), points.end());
  }
  return hull;
}

Vec2 extent_along(const std::vector<Vec2>& points, Vec2 x) {
  Vec2 low(kInfinity), high(-kInfinity);
  for (const Vec2 p : points) {
    const Vec2 q(dot(p, x), x.x * p.y - x.y * p.x);
    low = glm::min(low, q), high = glm::max(high, q);
  }
  return high - low;
}

/// The smallest rectangle around a convex polygon lies along one of its edges; the longest are tried.
Vec2 best_direction(const std::vector<Vec2>& hull) {
  constexpr size_t kTried = 32;
  std::vector<Vec2> edges;
  for (size_t i = 0; i < hull.size(); ++i) edges.push_back(hull[(i + 1) % hull.size()] - hull[i]);
  std::stable_sort(edges.begin(), edges.end(), [](Vec2 a, Vec2 b) { return dot(a, a) > dot(b, b); });
  edges.resize(std::min(edges.size(), kTried));
  Vec2 best(1, 0);
  float least = kInfinity;
  for (const Vec2 edge : edges) {
    if (!(dot(edge, edge) > 0)) continue;
    const Vec2 along = normalize(edge), extent = extent_along(hull, along);
    if (!(extent.x * extent.y < least * 0.9999f)) continue;
    least = extent.x * extent.y, best = extent.x >= extent.y ? along : Vec2(-along.y, along.x);
  }
  return best;
}

}  // namespace

void settle(Chart& chart) {
  Vec2 low(kInfinity), high(-kInfinity);
  for (const FlatTriangle& t : chart.corners)
    for (const Vec2 p : t) low = glm::min(low, p), high = glm::max(high, p);
  for (FlatTriangle& t : chart.corners)
    for (Vec2& p : t) p -= low;
  chart.size = high - low;
}

void turn_to_small_rectangle(Chart& chart) {
  const Vec2 x = best_direction(convex_hull(chart));
  for (FlatTriangle& t : chart.corners)
    for (Vec2& p : t) p = {dot(p, x), x.x * p.y - x.y * p.x};
  settle(chart);
}

std::vector<Chart> make_charts(const LightmapSurface& surface) { return Grower(surface).run(); }

}  // namespace aktina
