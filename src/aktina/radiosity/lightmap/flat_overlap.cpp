#include "aktina/radiosity/lightmap/flat_overlap.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

constexpr float kThin = 1e-5f;  // of the whole
constexpr uint64_t kMostPairs = 1000;
constexpr size_t kMostEntries = 8;  // cells of a triangle, on average

struct Rectangle {
  Vec2 low, high;
};

Rectangle around(const FlatTriangle& t) {
  return {glm::min(t[0], glm::min(t[1], t[2])), glm::max(t[0], glm::max(t[1], t[2]))};
}

/// Whether an edge of `a` has all of `b` on its outer side, but for `thin`.
bool parted_by_edge(const FlatTriangle& a, const FlatTriangle& b, float thin) {
  const float turn = twice_area(a) < 0 ? -1.0f : 1.0f;
  for (size_t k = 0; k < 3; ++k) {
    const Vec2 edge = a[(k + 1) % 3] - a[k];
    const float size = length(edge);
    if (!(size > 0)) continue;
    const Vec2 inward = Vec2(-edge.y, edge.x) * (turn / size);
    float deepest = -kInfinity;
    for (const Vec2 p : b) deepest = std::max(deepest, dot(p - a[k], inward));
    if (deepest <= thin) return true;
  }
  return false;
}

/// The triangles in the cells of a grid.
class Cells {
 public:
  explicit Cells(std::span<const FlatTriangle> triangles) : triangles_(triangles), all_(around(triangles[0])) {
    for (const FlatTriangle& t : triangles) {
      boxes_.push_back(around(t));
      all_.low = glm::min(all_.low, boxes_.back().low), all_.high = glm::max(all_.high, boxes_.back().high);
    }
    side_ = int(std::clamp(std::sqrt(double(triangles.size())), 1.0, 2048.0));
    while (side_ > 1 && entries() > kMostEntries * triangles.size()) side_ /= 2;
    fill();
  }

  float size() const { return std::max(all_.high.x - all_.low.x, all_.high.y - all_.low.y); }

  FlatOverlap find() const {
    FlatOverlap out;
    out.upon.assign(triangles_.size(), 0);
    uint64_t left = kMostPairs * triangles_.size() + 1'000'000;
    const float thin = kThin * size();
    for (size_t cell = 0; cell + 1 < first_.size(); ++cell)
      for (uint32_t i = first_[cell]; i < first_[cell + 1]; ++i)
        for (uint32_t k = first_[cell]; k < i; ++k) {
          if (--left == 0) return out.known = false, out;
          const uint32_t a = list_[k], b = list_[i];  // in their order
          if (out.upon[b] || index_of_shared_corner(a, b) != cell) continue;
          if (parted_by_edge(triangles_[a], triangles_[b], thin) || parted_by_edge(triangles_[b], triangles_[a], thin))
            continue;
          out.upon[b] = 1, ++out.count;
        }
    return out;
  }

 private:
  int cell(float x, float low, float high) const {
    return high > low ? std::clamp(int((x - low) / (high - low) * float(side_)), 0, side_ - 1) : 0;
  }
  int column(float x) const { return cell(x, all_.low.x, all_.high.x); }
  int row(float y) const { return cell(y, all_.low.y, all_.high.y); }
  size_t index(int x, int y) const { return size_t(y) * size_t(side_) + size_t(x); }

  size_t entries() const {
    size_t sum = 0;
    for (const Rectangle& b : boxes_)
      sum += size_t(column(b.high.x) - column(b.low.x) + 1) * size_t(row(b.high.y) - row(b.low.y) + 1);
    return sum;
  }
  template <class Visit>
  void each_cell(const Rectangle& b, const Visit& visit) const {
    for (int y = row(b.low.y); y <= row(b.high.y); ++y)
      for (int x = column(b.low.x); x <= column(b.high.x); ++x) visit(index(x, y));
  }
  void fill() {
    first_.assign(size_t(side_) * size_t(side_) + 1, 0);
    for (const Rectangle& b : boxes_) each_cell(b, [&](size_t at) { ++first_[at + 1]; });
    for (size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    list_.resize(first_.back());
    std::vector<uint32_t> cursor(first_.begin(), first_.end() - 1);
    for (uint32_t t = 0; t < boxes_.size(); ++t) each_cell(boxes_[t], [&](size_t at) { list_[cursor[at]++] = t; });
  }
  /// The one cell in which a pair of triangles is looked at; beyond the grid where their boxes are apart.
  size_t index_of_shared_corner(uint32_t a, uint32_t b) const {
    const Vec2 low = glm::max(boxes_[a].low, boxes_[b].low), high = glm::min(boxes_[a].high, boxes_[b].high);
    return low.x <= high.x && low.y <= high.y ? index(column(low.x), row(low.y)) : first_.size();
  }

  std::span<const FlatTriangle> triangles_;
  std::vector<Rectangle> boxes_;
  Rectangle all_;
  int side_ = 1;
  std::vector<uint32_t> first_, list_;
};

}  // namespace

FlatOverlap flat_overlap(std::span<const FlatTriangle> triangles) {
  FlatOverlap none;
  none.upon.assign(triangles.size(), 0);
  return triangles.size() < 2 ? none : Cells(triangles).find();
}

}  // namespace aktina
