#include "aktina/scene/mesh_check.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

#include "aktina/scene/corners.h"

namespace aktina {
namespace {

using Triangle = std::array<uint32_t, 3>;

constexpr uint64_t kMostWork = 50'000'000;  // pairs of boundary vertex and edge that are looked at for T-junctions

/// An edge between two places.
struct Edge {
  uint32_t low, high;
};

/// Side of a triangle seen from one of its ends.
struct Spoke {
  uint32_t other;  // place at the far end
  uint32_t triangle;
  uint32_t corner;  // index into the list of corners at the near end
  bool leaves;      // towards the far end, the way round the triangle goes
};

/// Goes from place to place and looks at the triangles that meet there.
class Checker {
 public:
  Checker(std::span<const Point3> positions, std::span<const Triangle> triangles)
      : positions_(positions), triangles_(triangles), meeting_(positions, triangles), left_out_(triangles.size()) {}

  MeshCheck run() {
    out_.triangles = triangles_.size();
    for (uint32_t t = 0; t < triangles_.size(); ++t)
      if (!(twice_area(triangles_[t]) > 0)) left_out_[t] = true, ++out_.degenerate;
    for (size_t place = 0; place < meeting_.places(); ++place) drop_duplicates(uint32_t(place));
    measure();
    pieces_.resize(triangles_.size());
    std::iota(pieces_.begin(), pieces_.end(), 0u);
    for (size_t place = 0; place < meeting_.places(); ++place) look_around(uint32_t(place));
    for (uint32_t t = 0; t < pieces_.size(); ++t) out_.pieces += !left_out_[t] && root(pieces_, t) == t;
    find_t_junctions();
    return out_;
  }

 private:
  uint32_t place(uint32_t t, uint32_t k) const { return meeting_.place(triangles_[t][k]); }

  double twice_area(const Triangle& t) const {
    const Vec3d a(positions_[t[0]]);
    return length(cross(Vec3d(positions_[t[1]]) - a, Vec3d(positions_[t[2]]) - a));
  }

  /// The triangles whose lowest place this is: those with the same three places again.
  void drop_duplicates(uint32_t lowest) {
    alike_.clear();
    for (const uint32_t corner : meeting_.at(lowest)) {
      const uint32_t t = corner / 3;
      const uint32_t a = place(t, (corner + 1) % 3), b = place(t, (corner + 2) % 3);
      if (!left_out_[t] && a > lowest && b > lowest) alike_.push_back({std::min(a, b), std::max(a, b), t});
    }
    std::sort(alike_.begin(), alike_.end());
    for (size_t i = 1; i < alike_.size(); ++i)
      if (alike_[i][0] == alike_[i - 1][0] && alike_[i][1] == alike_[i - 1][1])
        left_out_[alike_[i][2]] = true, ++out_.duplicate;
  }

  void measure() {
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
      if (left_out_[t]) continue;
      const auto corner = [&](size_t k) { return Vec3d(positions_[triangles_[t][k]]); };
      out_.area += twice_area(triangles_[t]) / 2;
      out_.volume += dot(corner(0), cross(corner(1), corner(2))) / 6;
    }
  }

  static uint32_t root(std::vector<uint32_t>& parents, uint32_t i) {
    while (parents[i] != i) i = parents[i] = parents[parents[i]];
    return i;
  }
  static void join(std::vector<uint32_t>& parents, uint32_t a, uint32_t b) {
    parents[root(parents, a)] = root(parents, b);
  }

  /// Corners at a place that no chain of shared edges connects belong to different fans.
  void look_around(uint32_t near) {
    spokes_.clear();
    uint32_t corners = 0;
    for (const uint32_t id : meeting_.at(near)) {
      const uint32_t t = id / 3;
      if (left_out_[t]) continue;
      spokes_.push_back({place(t, (id + 1) % 3), t, corners, true});
      spokes_.push_back({place(t, (id + 2) % 3), t, corners++, false});
    }
    fans_.resize(corners);
    std::iota(fans_.begin(), fans_.end(), 0u);
    std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) {
      return a.other != b.other ? a.other < b.other : a.triangle < b.triangle;
    });
    for (size_t i = 0, end = 0; i < spokes_.size(); i = end) {
      while (end < spokes_.size() && spokes_[end].other == spokes_[i].other) ++end;
      const std::span<const Spoke> edge(&spokes_[i], end - i);
      for (const Spoke& spoke : edge) join(fans_, edge[0].corner, spoke.corner);
      if (near < edge[0].other) count_edge(near, edge);
    }
    uint32_t fans = 0;
    for (uint32_t c = 0; c < corners; ++c) fans += fans_[c] == c;
    out_.pinched_vertices += fans > 1;
  }

  void count_edge(uint32_t near, std::span<const Spoke> edge) {
    ++out_.edges;
    if (edge.size() == 1) ++out_.boundary_edges, boundary_.push_back({near, edge[0].other});
    if (edge.size() > 2) ++out_.non_manifold_edges;
    if (edge.size() == 2 && edge[0].leaves == edge[1].leaves) ++out_.inconsistent_edges;
    for (const Spoke& spoke : edge) join(pieces_, edge[0].triangle, spoke.triangle);
  }

  void find_t_junctions() {
    std::vector<uint32_t> vertices;
    for (const Edge& side : boundary_) vertices.push_back(side.low), vertices.push_back(side.high);
    const auto left = [&](uint32_t a, uint32_t b) {
      return positions_[a].x != positions_[b].x ? positions_[a].x < positions_[b].x : a < b;
    };
    std::sort(vertices.begin(), vertices.end(), left);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::set<uint32_t> found;
    uint64_t work = 0;
    for (const Edge& side : boundary_) {
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
  std::span<const Triangle> triangles_;
  CornersByPlace meeting_;
  std::vector<bool> left_out_;  // degenerate and duplicate triangles
  MeshCheck out_;
  std::vector<uint32_t> pieces_;  // of triangles
  std::vector<Edge> boundary_;
  std::vector<std::array<uint32_t, 3>> alike_;  // at the place in hand: the two other places, the triangle
  std::vector<Spoke> spokes_;                   // there
  std::vector<uint32_t> fans_;                  // of corners there
};

}  // namespace

MeshCheck check_mesh(std::span<const Point3> positions, std::span<const Triangle> triangles) {
  return Checker(positions, triangles).run();
}

}  // namespace aktina
