#include "aktina/radiosity/solver/hierarchy/surface_tree.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

constexpr double kParallelogram = 1e-4;  // relative gap of the fourth corner
constexpr double kSliver = 1e-7;         // of a node's area: what is less does not overlap

/// Coordinates of points of a root's plane along its edges.
class RootCoordinates {
 public:
  explicit RootCoordinates(const TreePatch& root) : corner_(root.corner) {
    const Vec3d u(root.u), v(root.v);
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), det = uu * vv - uv * uv;
    along_u_ = (u * vv - v * uv) / det, along_v_ = (v * uu - u * uv) / det;
  }
  Vec2d operator()(Point3 p) const {
    const Vec3d d = Vec3d(p) - corner_;
    return {dot(d, along_u_), dot(d, along_v_)};
  }

 private:
  Vec3d corner_, along_u_, along_v_;
};

}  // namespace

Point3 TreePatch::place(Vec2 at) const {
  if (!triangle) return point(at.x, at.y);
  const float root = std::sqrt(at.x);
  return point(root * (1 - at.y), root * at.y);
}

std::array<Point3, 4> TreePatch::corners() const {
  if (triangle) return {corner, corner + u, corner + v, corner + v};
  return {corner, corner + u, corner + u + v, corner + v};
}

float TreePatch::radius() const {
  if (!triangle) return 0.5f * std::sqrt(std::max(squared_length(u + v), squared_length(u - v)));
  return std::sqrt(std::max({squared_length(u + v), squared_length(2.0f * u - v), squared_length(2.0f * v - u)})) / 3;
}

TreePatch TreePatch::quarter(int c) const {
  const float half = triangle && c == 3 ? -0.5f : 0.5f;
  return {point(c & 1 ? 0.5f : 0, c & 2 ? 0.5f : 0), half * u, half * v, normal, triangle, area / 4};
}

SurfaceTree::SurfaceTree(const SurfaceLayout& layout, double size) {
  for (size_t f = 0; f < layout.faces.size(); ++f)
    add_roots(
        layout.faces[f],
        Pieces(layout.pieces).subspan(layout.first_pieces[f], layout.first_pieces[f + 1] - layout.first_pieces[f]),
        size);
}

void SurfaceTree::add_roots(const SurfaceLayout::Face& face, Pieces pieces, double size) {
  double covered = 0;
  for (const SurfaceLayout::Piece& piece : pieces) covered += piece.area;
  const double smallest = size * covered / double(pieces.size());
  const auto& c = face.corners;
  const auto triangle = [&](size_t i, size_t j, size_t k) {
    TreePatch root{c[i], c[j] - c[i], c[k] - c[i], face.normal, true, 0};
    root.area = 0.5 * length(cross(Vec3d(root.u), Vec3d(root.v)));
    add_root(root, smallest, pieces);
  };
  if (c[2] == c[3]) return triangle(0, 1, 2);
  const double gap = length(Vec3d(c[0]) - Vec3d(c[1]) + Vec3d(c[2]) - Vec3d(c[3]));
  if (gap > kParallelogram * length(Vec3d(c[2]) - Vec3d(c[0]))) {
    triangle(0, 1, 2), triangle(2, 3, 0);
    return;
  }
  TreePatch root{c[0], c[1] - c[0], c[3] - c[0], face.normal, false, 0};
  root.area = length(cross(Vec3d(root.u), Vec3d(root.v)));
  add_root(root, smallest, pieces);
}

void SurfaceTree::add_root(const TreePatch& root, double smallest, Pieces pieces) {
  roots_.push_back(root), smallest_.push_back(smallest);
  nodes_.push_back({0, 0, 1, uint32_t(roots_.size()) - 1});
  overlaps_.emplace_back();
  const RootCoordinates coordinates(root);
  std::vector<Overlap> all;
  for (const SurfaceLayout::Piece& each : pieces) {
    const auto& c = each.corners;
    all.push_back({uint32_t(pieces_.size()), each.receiver, each.area});
    pieces_.push_back({{coordinates(c[0]), coordinates(c[1]), coordinates(c[2]), coordinates(c[3])},
                       each.receiver,
                       c[2] == c[3],
                       each.area});
  }
  find_overlaps(uint32_t(nodes_.size()) - 1, all);
}

TreePatch SurfaceTree::patch(uint32_t node) const {
  const TreeNode& n = nodes_[node];
  const TreePatch& r = roots_[n.root];
  return {r.point(n.a, n.b), n.h * r.u, n.h * r.v, r.normal, r.triangle, area(node)};
}

uint32_t SurfaceTree::cut(uint32_t node) {
  const TreeNode n = nodes_[node];
  const bool triangle = roots_[n.root].triangle;
  const auto first = uint32_t(nodes_.size());
  const float half = n.h / 2;
  nodes_[node].children = first;
  nodes_.push_back({n.a, n.b, half, n.root});
  nodes_.push_back({n.a + half, n.b, half, n.root});
  nodes_.push_back({n.a, n.b + half, half, n.root});
  nodes_.push_back({n.a + half, n.b + half, triangle ? -half : half, n.root});
  overlaps_.resize(nodes_.size());
  const std::vector<Overlap> all = std::move(overlaps_[node]);
  for (uint32_t k = 0; k < 4; ++k) find_overlaps(first + k, all);
  overlaps_[node] = {};
  return first;
}

FlatPolygon SurfaceTree::common_part(uint32_t leaf, uint32_t piece) const {
  const TreeNode& n = nodes_[leaf];
  const Piece& of = pieces_[piece];
  FlatPolygon p;
  for (size_t k = 0; k < (of.triangle ? 3U : 4U); ++k)
    p.push_back((of.corners[k] - Vec2d(double(n.a), double(n.b))) / double(n.h));
  cut_by_reference(p, roots_[n.root].triangle);
  return p;
}

/// Of a node, and a piece that has `with.area` in common with its parent.
double SurfaceTree::common_area(uint32_t node, const Overlap& with) const {
  const TreeNode& n = nodes_[node];
  const bool triangle = roots_[n.root].triangle;
  Vec2d low(1e300), high(-1e300);
  for (const Vec2d& corner : pieces_[with.piece].corners) {
    const Vec2d p = (corner - Vec2d(double(n.a), double(n.b))) / double(n.h);
    low = glm::min(low, p), high = glm::max(high, p);
  }
  if (high.x <= 0 || high.y <= 0) return 0;
  if (triangle ? low.x + low.y >= 1 : low.x >= 1 || low.y >= 1) return 0;
  const bool within = low.x >= 0 && low.y >= 0 && (triangle ? high.x + high.y <= 1 : high.x <= 1 && high.y <= 1);
  if (within) return pieces_[with.piece].area;
  return area_of(common_part(node, with.piece)) / (triangle ? 0.5 : 1) * area(node);
}

void SurfaceTree::find_overlaps(uint32_t node, std::span<const Overlap> candidates) {
  const double all = area(node);
  double covered = 0;
  for (const Overlap& each : candidates) {
    const double common = common_area(node, each);
    if (!(common > kSliver * all)) continue;
    overlaps_[node].push_back({each.piece, each.receiver, common});
    covered += common;
  }
  nodes_[node].covered = float(std::min(covered / all, 1.0));
}

}  // namespace aktina
