#include "aktina/radiosity/mesher/junctions.h"

#include <algorithm>
#include <cmath>

#include "aktina/scene/weld.h"

namespace aktina {
namespace {

constexpr size_t kLeaf = 8;  // points that are looked at one by one

}  // namespace

/// What is searched for: p(t) = start + t along.
struct Junctions::Edge {
  Point3 a, b;
  Vec3d start, along;
  double squared, tolerance, margin;  // m^2, m, share of the length
  std::vector<std::pair<double, Point3>>& found;

  void test(Point3 p) const {
    const Vec3d to = Vec3d(p) - start;
    const double t = dot(to, along) / squared;
    if (!(t > margin && t < 1 - margin) || p == a || p == b) return;
    if (squared_length(to - t * along) <= tolerance * tolerance) found.emplace_back(t, p);
  }
};

Junctions::Junctions(std::span<const Point3> points) {
  const std::vector<uint32_t> same = weld(points);
  Bounds bounds;
  for (size_t i = 0; i < points.size(); ++i)
    if (same[i] == i && is_finite(points[i])) points_.push_back(points[i]), bounds.add(points[i]);
  if (points_.empty()) return;
  tolerance_ = kJunctionTolerance * bounds.diagonal();
  axes_.resize(points_.size());
  build(0, points_.size());
}

void Junctions::build(size_t begin, size_t end) {
  if (end - begin <= kLeaf) return;
  Bounds box;
  for (size_t i = begin; i < end; ++i) box.add(points_[i]);
  const Vec3 size = box.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const size_t middle = (begin + end) / 2;
  const auto at = [&](size_t i) { return points_.begin() + std::ptrdiff_t(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](Point3 l, Point3 r) { return l[axis] < r[axis]; });
  axes_[middle] = uint8_t(axis);
  build(begin, middle);
  build(middle + 1, end);
}

/// Points of a range near the piece of the edge between two parameters.
void Junctions::search(size_t begin, size_t end, const Edge& edge, double from, double to) const {
  if (end - begin <= kLeaf) {
    for (size_t i = begin; i < end; ++i) edge.test(points_[i]);
    return;
  }
  const size_t middle = (begin + end) / 2;
  const int axis = axes_[middle];
  const double split = double(points_[middle][axis]), slope = edge.along[axis];
  const double at_from = edge.start[axis] + from * slope, at_to = edge.start[axis] + to * slope;
  const double low = std::min(at_from, at_to) - edge.tolerance, high = std::max(at_from, at_to) + edge.tolerance;
  edge.test(points_[middle]);
  const auto cut = [&](double plane) { return std::clamp((plane - edge.start[axis]) / slope, from, to); };
  const bool crosses = at_from != at_to;
  if (low <= split) {  // the part of the piece below the plane, and a little more
    const double t = crosses && high > split ? cut(split + edge.tolerance) : slope > 0 ? to : from;
    slope > 0 ? search(begin, middle, edge, from, t) : search(begin, middle, edge, t, to);
  }
  if (high >= split) {
    const double t = crosses && low < split ? cut(split - edge.tolerance) : slope > 0 ? from : to;
    slope > 0 ? search(middle + 1, end, edge, t, to) : search(middle + 1, end, edge, from, t);
  }
}

void Junctions::on_edge(Point3 a, Point3 b, std::vector<Point3>& found) const {
  found.clear();
  if (b.x != a.x ? b.x < a.x : b.y != a.y ? b.y < a.y : b.z < a.z) {  // the same points from both sides
    on_edge(b, a, found);
    std::reverse(found.begin(), found.end());
    return;
  }
  const Vec3d start(a), along = Vec3d(b) - start;
  const double squared = squared_length(along), margin = double(tolerance_) / std::sqrt(squared);
  if (points_.empty() || !(squared > 0)) return;
  std::vector<std::pair<double, Point3>> on;
  search(0, points_.size(), {a, b, start, along, squared, double(tolerance_), margin, on}, 0, 1);
  std::sort(on.begin(), on.end(), [](const auto& l, const auto& r) { return l.first < r.first; });
  double last = 0;  // of points closer than the tolerance one counts
  for (const auto& [t, p] : on)
    if (t > last + margin) found.push_back(p), last = t;
}

}  // namespace aktina
