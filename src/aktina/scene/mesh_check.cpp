#include "aktina/scene/mesh_check.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

#include "aktina/scene/weld.h"

namespace aktina {
namespace {

using Triangle = std::array<uint32_t, 3>;

constexpr uint64_t kMostWork = 50'000'000;  // pairs of boundary vertex and edge that are looked at for T-junctions

/// Side k of triangle t, from corner k to the next.
struct Side {
  uint32_t low, high;  // vertices
  uint32_t triangle, corner;
  bool forward;  // from low to high
};

class Checker {
 public:
  Checker(std::span<const Point3> positions, std::span<const Triangle> triangles) : positions_(positions) {
    const std::vector<uint32_t> place = weld(positions);
    out_.triangles = triangles.size();
    for (const Triangle& t : triangles) {
      const Triangle welded{place[t[0]], place[t[1]], place[t[2]]};
      if (twice_area(welded) > 0)
        triangles_.push_back(welded);
      else
        ++out_.degenerate;
    }
    drop_duplicates();
    for (const Triangle& t : triangles_) {
      const Vec3d a(positions[t[0]]), b(positions[t[1]]), c(positions[t[2]]);
      out_.area += twice_area(t) / 2;
      out_.volume += dot(a, cross(b, c)) / 6;
    }
  }

  MeshCheck run() {
    collect_sides();
    parents_.resize(3 * triangles_.size());
    std::iota(parents_.begin(), parents_.end(), 0u);
    pieces_.resize(triangles_.size());
    std::iota(pieces_.begin(), pieces_.end(), 0u);
    for (size_t i = 0, end = 0; i < sides_.size(); i = end) {
      while (end < sides_.size() && sides_[end].low == sides_[i].low && sides_[end].high == sides_[i].high) ++end;
      edge(std::span(sides_).subspan(i, end - i));
    }
    count_fans();
    for (uint32_t t = 0; t < pieces_.size(); ++t) out_.pieces += root(pieces_, t) == t;
    find_t_junctions();
    return out_;
  }

 private:
  double twice_area(const Triangle& t) const {
    const Vec3d a(positions_[t[0]]);
    return length(cross(Vec3d(positions_[t[1]]) - a, Vec3d(positions_[t[2]]) - a));
  }

  void drop_duplicates() {
    std::vector<std::pair<Triangle, uint32_t>> sorted;
    for (uint32_t i = 0; i < triangles_.size(); ++i) {
      sorted.emplace_back(triangles_[i], i);
      std::sort(sorted.back().first.begin(), sorted.back().first.end());
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<Triangle> kept;
    for (size_t i = 0; i < sorted.size(); ++i)
      if (i > 0 && sorted[i].first == sorted[i - 1].first)
        ++out_.duplicate;
      else
        kept.push_back(triangles_[sorted[i].second]);
    triangles_ = std::move(kept);
  }

  void collect_sides() {
    for (uint32_t t = 0; t < triangles_.size(); ++t)
      for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
        sides_.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
      }
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
      return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
    });
  }

  static uint32_t root(std::vector<uint32_t>& parents, uint32_t i) {
    while (parents[i] != i) i = parents[i] = parents[parents[i]];
    return i;
  }
  static void join(std::vector<uint32_t>& parents, uint32_t a, uint32_t b) {
    parents[root(parents, a)] = root(parents, b);
  }

  void edge(std::span<const Side> group) {
    ++out_.edges;
    if (group.size() == 1) ++out_.boundary_edges, boundary_.push_back(group[0]);
    if (group.size() > 2) ++out_.non_manifold_edges;
    if (group.size() == 2 && group[0].forward == group[1].forward) ++out_.inconsistent_edges;
    for (size_t i = 1; i < group.size(); ++i) {
      join(pieces_, group[0].triangle, group[i].triangle);
      join(parents_, corner_at(group[0], group[0].low), corner_at(group[i], group[0].low));
      join(parents_, corner_at(group[0], group[0].high), corner_at(group[i], group[0].high));
    }
  }
  /// 3 * triangle + corner of the side's end at `vertex`.
  static uint32_t corner_at(const Side& side, uint32_t vertex) {
    const bool first = (side.forward ? side.low : side.high) == vertex;
    return 3 * side.triangle + (first ? side.corner : (side.corner + 1) % 3);
  }

  /// Corners at a vertex that no chain of shared edges connects belong to different fans.
  void count_fans() {
    std::vector<uint8_t> fans(positions_.size(), 0);
    for (uint32_t corner = 0; corner < parents_.size(); ++corner) {
      if (root(parents_, corner) != corner) continue;
      uint8_t& count = fans[triangles_[corner / 3][corner % 3]];
      if (count < 2) ++count;
    }
    out_.pinched_vertices = uint64_t(std::count(fans.begin(), fans.end(), 2));
  }

  void find_t_junctions() {
    std::vector<uint32_t> vertices;
    for (const Side& side : boundary_) vertices.push_back(side.low), vertices.push_back(side.high);
    const auto left = [&](uint32_t a, uint32_t b) {
      return positions_[a].x != positions_[b].x ? positions_[a].x < positions_[b].x : a < b;
    };
    std::sort(vertices.begin(), vertices.end(), left);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::set<uint32_t> found;
    uint64_t work = 0;
    for (const Side& side : boundary_) {
      const Point3 a = positions_[side.low], b = positions_[side.high];
      const float low = std::min(a.x, b.x), high = std::max(a.x, b.x), slack = 1e-6f * length(b - a);
      auto at = std::lower_bound(vertices.begin(), vertices.end(), low - slack,
                                 [&](uint32_t v, float x) { return positions_[v].x < x; });
      for (; at != vertices.end() && positions_[*at].x <= high + slack && ++work < kMostWork; ++at)
        if (*at != side.low && *at != side.high && within(positions_[*at], a, b)) found.insert(*at);
    }
    out_.t_junctions = found.size();
  }
  /// On the edge, a millionth of its length off at most.
  static bool within(Point3 p, Point3 a, Point3 b) {
    const Vec3d edge = Vec3d(b) - Vec3d(a), d = Vec3d(p) - Vec3d(a);
    const double along = dot(d, edge) / dot(edge, edge);
    return along > 1e-6 && along < 1 - 1e-6 && length(d - edge * along) < 1e-6 * length(edge);
  }

  std::span<const Point3> positions_;
  MeshCheck out_;
  std::vector<Triangle> triangles_;
  std::vector<Side> sides_, boundary_;
  std::vector<uint32_t> parents_, pieces_;
};

}  // namespace

MeshCheck check_mesh(std::span<const Point3> positions, std::span<const Triangle> triangles) {
  return Checker(positions, triangles).run();
}

}  // namespace aktina
