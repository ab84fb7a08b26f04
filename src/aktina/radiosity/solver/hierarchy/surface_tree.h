// Surfaces cut into quarters of quarters: where hierarchical solvers keep their light.
//
// Every face is the root of a tree. A node's four children are its exact quarters: those of a parallelogram by its
// middle lines, those of a triangle by the middles of its edges. Other quadrilaterals are two triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "aktina/radiosity/solver/hierarchy/flat_polygon.h"
#include "aktina/radiosity/solver/receiver_surfaces.h"

namespace aktina {

/// A parallelogram, or a triangle (corner, corner + u, corner + v); the front is towards u x v.
struct TreePatch {
  Point3 corner;
  Vec3 u, v, normal;
  bool triangle;
  double area;  // m^2

  /// The place at reference coordinates (x, y): in [0, 1]^2, on a triangle x + y <= 1.
  Point3 point(float x, float y) const { return corner + x * u + y * v; }
  /// Evenly over the area where `at` is over the unit square.
  Point3 place(Vec2 at) const;
  Point3 middle() const { return triangle ? point(1.0f / 3, 1.0f / 3) : point(0.5f, 0.5f); }
  float radius() const;                   // of a sphere about the middle, m
  std::array<Point3, 4> corners() const;  // counter-clockwise; the last two of a triangle are equal
  TreePatch quarter(int c) const;
};

/// The part root.point(a + h x, b + h y) of a root. h < 0: upside down, as the middle quarter of a triangle is.
struct TreeNode {
  static constexpr uint32_t kNone = 0xffffffff;
  float a, b, h;
  uint32_t root;
  uint32_t children = kNone;  // the first of four, one after the other; kNone: a leaf
  float covered = 0;          // share of its area that belongs to receivers; the rest is buried
};

class SurfaceTree {
 public:
  /// What a leaf and a receiver have in common.
  struct Overlap {
    uint32_t piece;
    uint32_t receiver;
    double area;  // m^2
  };

  /// @param size  of the smallest nodes: their area over the mean area of what receivers cover of a face
  SurfaceTree(const SurfaceLayout& layout, double size);

  const std::vector<TreeNode>& nodes() const { return nodes_; }
  const std::vector<TreePatch>& roots() const { return roots_; }  // root k is node k
  const TreePatch& root(uint32_t node) const { return roots_[nodes_[node].root]; }
  bool is_leaf(uint32_t node) const { return nodes_[node].children == TreeNode::kNone; }
  double area(uint32_t node) const { return root(node).area * double(nodes_[node].h) * double(nodes_[node].h); }
  bool may_be_cut(uint32_t node) const { return !is_leaf(node) || area(node) > smallest_[nodes_[node].root]; }
  TreePatch patch(uint32_t node) const;

  /// Cuts a leaf; returns the first of its children.
  uint32_t cut(uint32_t node);
  /// Of leaves only.
  std::span<const Overlap> overlaps(uint32_t leaf) const { return overlaps_[leaf]; }
  /// What a leaf and a piece have in common, in the leaf's reference coordinates; convex.
  FlatPolygon common_part(uint32_t leaf, uint32_t piece) const;

 private:
  using Pieces = std::span<const SurfaceLayout::Piece>;
  /// What a receiver has of a root: corners in the root's coordinates.
  struct Piece {
    std::array<Vec2d, 4> corners;
    uint32_t receiver;
    bool triangle;
    double area;  // m^2
  };
  void add_roots(const SurfaceLayout::Face& face, Pieces pieces, double size);
  void add_root(const TreePatch& root, double smallest, Pieces pieces);
  void find_overlaps(uint32_t node, std::span<const Overlap> candidates);
  double common_area(uint32_t node, const Overlap& with) const;

  std::vector<Piece> pieces_;
  std::vector<TreePatch> roots_;
  std::vector<double> smallest_;  // by root: nodes of less area are not cut, m^2
  std::vector<TreeNode> nodes_;
  std::vector<std::vector<Overlap>> overlaps_;  // by node; emptied when it is cut
};

}  // namespace aktina
