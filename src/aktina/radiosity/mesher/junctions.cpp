#include "aktina/radiosity/mesher/junctions.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "aktina/scene/weld.h"

namespace aktina {
namespace {

constexpr float kMostCells = 512;  // along an axis

}  // namespace

Junctions::Junctions(std::span<const Point3> points) {
  const std::vector<uint32_t> same = weld(points);
  std::vector<Point3> unique;
  for (size_t i = 0; i < points.size(); ++i)
    if (same[i] == i && is_finite(points[i])) unique.push_back(points[i]), bounds_.add(points[i]);
  if (unique.empty()) return;
  tolerance_ = kJunctionTolerance * bounds_.diagonal();
  const Vec3 size = glm::max(bounds_.size(), Vec3(1e-3f * bounds_.diagonal() + 1e-30f));
  const float cell = std::cbrt(size.x * size.y * size.z / float(unique.size()));
  count_ = Cell(glm::clamp(size / cell, Vec3(1), Vec3(kMostCells)));
  per_metre_ = Vec3(count_) / size;

  first_.assign(size_t(count_.x) * size_t(count_.y) * size_t(count_.z) + 1, 0);
  for (const Point3 p : unique) ++first_[index(cell_of(p)) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<uint32_t> cursor(first_.begin(), first_.end() - 1);
  points_.resize(unique.size());
  for (const Point3 p : unique) points_[cursor[index(cell_of(p))]++] = p;
}

Junctions::Cell Junctions::cell_of(Point3 p) const {
  return glm::clamp(Cell((p - bounds_.low) * per_metre_), Cell(0), count_ - 1);
}

/// Points near the piece of the edge between two parameters: halved until its box touches few cells.
void Junctions::search(Point3 a, Point3 b, float from, float to, std::vector<uint32_t>& found) const {
  Bounds box;
  box.add(a + (b - a) * from), box.add(a + (b - a) * to);
  const Cell low = cell_of(box.low - tolerance_), high = cell_of(box.high + tolerance_), span = high - low;
  if (std::max({span.x, span.y, span.z}) > 2) {
    const float middle = 0.5f * (from + to);
    search(a, b, from, middle, found);
    search(a, b, middle, to, found);
    return;
  }
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x)
        for (uint32_t i = first_[index({x, y, z})]; i < first_[index({x, y, z}) + 1]; ++i) found.push_back(i);
}

void Junctions::on_edge(Point3 a, Point3 b, std::vector<Point3>& found) const {
  found.clear();
  if (b.x != a.x ? b.x < a.x : b.y != a.y ? b.y < a.y : b.z < a.z) {  // the same points from both sides
    on_edge(b, a, found);
    std::reverse(found.begin(), found.end());
    return;
  }
  const Vec3d start(a), edge = Vec3d(b) - start;
  const double squared = squared_length(edge), margin = double(tolerance_) / std::sqrt(squared);
  if (points_.empty() || !(squared > 0)) return;
  std::vector<uint32_t> near;
  search(a, b, 0, 1, near);
  std::vector<std::pair<double, Point3>> on;
  for (const uint32_t i : near) {
    const Vec3d to = Vec3d(points_[i]) - start;
    const double t = dot(to, edge) / squared;
    if (!(t > margin && t < 1 - margin) || points_[i] == a || points_[i] == b) continue;
    if (squared_length(to - t * edge) <= double(tolerance_) * double(tolerance_)) on.emplace_back(t, points_[i]);
  }
  std::sort(on.begin(), on.end(), [](const auto& l, const auto& r) { return l.first < r.first; });
  double last = 0;  // what was found twice, at the ends of two pieces, comes once
  for (const auto& [t, p] : on)
    if (t > last + margin) found.push_back(p), last = t;
}

}  // namespace aktina
