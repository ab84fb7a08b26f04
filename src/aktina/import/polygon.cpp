// Ear clipping: G. H. Meisters, "Polygons Have Ears", American Mathematical Monthly 82(6), 1975.
#include "aktina/import/polygon.h"

#include <cmath>
#include <numeric>

namespace aktina {
namespace {

constexpr uint64_t kMostWork = 400'000'000;  // point-in-triangle tests of a whole file: about a second

double side(Vec2d a, Vec2d b, Vec2d c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

}  // namespace

/// Along the largest axis of Newell's normal, so that counter-clockwise stays it.
void Triangulator::project(std::span<const Point3> corners) {
  Vec3d normal(0);
  const Vec3d origin(corners[0]);
  for (size_t i = 0; i < corners.size(); ++i)
    normal += cross(Vec3d(corners[i]) - origin, Vec3d(corners[(i + 1) % corners.size()]) - origin);
  const Vec3d size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  points_.clear();
  for (const Point3 p : corners) {
    const Vec3d d = Vec3d(p) - origin;
    points_.push_back(normal[axis] < 0 ? Vec2d(d[v], d[u]) : Vec2d(d[u], d[v]));
  }
}

bool Triangulator::convex() const {
  const size_t n = points_.size();
  for (size_t i = 0; i < n; ++i)
    if (!(side(points_[i], points_[(i + 1) % n], points_[(i + 2) % n]) > 0)) return false;
  return true;
}

/// No other corner within the triangle at the i-th corner that is left.
bool Triangulator::is_ear(size_t i) {
  const size_t n = loop_.size();
  const uint32_t ia = loop_[(i + n - 1) % n], ib = loop_[i], ic = loop_[(i + 1) % n];
  const Vec2d a = points_[ia], b = points_[ib], c = points_[ic];
  if (!(side(a, b, c) > 0)) return false;
  work_ += n;
  for (const uint32_t k : loop_) {
    if (k == ia || k == ib || k == ic) continue;
    const Vec2d p = points_[k];
    if (p == a || p == b || p == c) continue;  // a bridge to a hole names its corners twice
    if (side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0) return false;
  }
  return true;
}

bool Triangulator::clip_ears() {
  size_t i = 0, failed = 0;
  while (loop_.size() > 3) {
    const size_t n = loop_.size();
    if (failed >= n || work_ > kMostWork) return false;
    if (!is_ear(i % n)) {
      ++i, ++failed;
      continue;
    }
    i %= n, failed = 0;
    triangles_.push_back({loop_[(i + n - 1) % n], loop_[i], loop_[(i + 1) % n]});
    loop_.erase(loop_.begin() + long(i));
  }
  triangles_.push_back({loop_[0], loop_[1], loop_[2]});
  return true;
}

void Triangulator::fan() {
  for (size_t i = 2; i < loop_.size(); ++i) triangles_.push_back({loop_[0], loop_[i - 1], loop_[i]});
}

std::span<const std::array<uint32_t, 3>> Triangulator::triangulate(std::span<const Point3> corners) {
  triangles_.clear();
  loop_.resize(corners.size());
  std::iota(loop_.begin(), loop_.end(), 0u);
  if (corners.size() == 3) {
    triangles_.push_back({0, 1, 2});
    return triangles_;
  }
  project(corners);
  if (convex()) {
    if (corners.size() == 4 && length(points_[1] - points_[3]) < length(points_[0] - points_[2])) loop_ = {1, 2, 3, 0};
    fan();
  } else if (!clip_ears()) {
    ++given_up_;
    fan();
  }
  return triangles_;
}

}  // namespace aktina
