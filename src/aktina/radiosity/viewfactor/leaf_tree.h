// The leaves of a scene in a tree, those of one plane together: whole groups of them that a leaf cannot see, or that
// one blocker hides from it, are passed over at once.
#pragma once

#include "aktina/base/function_ref.h"
#include "aktina/radiosity/viewfactor/leaf_pair.h"

namespace aktina {

class LeafTree {
 public:
  /// Puts the leaves into the tree's order. They must stay where they are.
  explicit LeafTree(std::vector<Leaf>& leaves);

  /// Leaves that may see `leaf`, in ascending order; among those passed over none does.
  /// @param from  leaves below it are left out
  void visit(const Leaf& leaf, uint32_t from, const BlockerTree& blockers, double tolerance,
             FunctionRef<void(uint32_t)> visitor) const;

 private:
  struct Node {
    std::array<Point3d, 8> corners;  // of its box
    Point3d centre;                  // of a sphere around it
    double radius;
    uint32_t first, count;  // leaves
    uint32_t right;         // the left child follows
    bool one_plane;
  };
  struct Group {
    uint32_t first, count;
    Point3d centre;
  };
  void order(std::vector<Group>& groups, size_t first, size_t count);
  uint32_t build(const std::vector<Group>& groups, size_t first, size_t count);
  uint32_t build(uint32_t first, uint32_t count, bool one_plane);
  bool is_hidden(const Node& node, const Leaf& leaf, const BlockerTree& blockers, double tolerance) const;
  bool faces(const Node& node, const Leaf& leaf, double tolerance) const;

  const std::vector<Leaf>& leaves_;
  std::vector<Node> nodes_;
};

}  // namespace aktina
