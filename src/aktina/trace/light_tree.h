// Which of many lamps to sample at a point: a binary tree of boxes, powers and cones of directions.
#pragma once

#include <cstdint>
#include <vector>

#include "aktina/base/vec.h"

namespace aktina {

/// A lamp, or all lamps below a node: where they are, how much they shine, and in what directions.
struct LampBounds {
  Bounds box;
  float power = 0;
  Vec3 axis{0, 0, 1};    // unit, of the cone that holds all normals
  float spread = 0;      // rad, half angle of that cone
  float beam = 1.5708f;  // rad, from a normal: how far a lamp shines
};

/// Lamps are picked with a chance that follows what they can do at a point: power, distance and direction. One number
/// leads from the root to a lamp; cost: the depth of the tree, whose halves have equally many lamps.
/// A. Conty Estevez, C. Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", HPG 2018.
class LightTree {
 public:
  /// Lamps without power are never picked.
  void build(std::vector<LampBounds> lamps);
  bool empty() const { return nodes_.empty(); }
  bool only_one() const { return nodes_.size() == 1; }

  struct Choice {
    uint32_t lamp;
    float chance;  // 0: no lamp reaches the point
  };
  /// @param u  in [0, 1)
  Choice pick(Point3 x, float u) const;
  /// The chance with which pick() gives this lamp at x.
  float chance(Point3 x, uint32_t lamp) const;

 private:
  struct Node {
    Point3 centre;
    float squared_radius, power;
    Vec3 axis;
    float cos_spread, sin_spread, cos_beam;  // of spread + beam limited to pi
    uint32_t right;                          // inner node: the left child follows at once; 0: a leaf
    uint32_t lamp;
  };
  uint32_t add(std::vector<LampBounds>& lamps, std::vector<uint32_t>& order, size_t first, size_t last, uint64_t path,
               int depth, LampBounds& bounds);
  static float importance(const Node& node, Point3 x);
  /// The share of the left child.
  float left_share(uint32_t node, Point3 x) const;

  std::vector<Node> nodes_;
  std::vector<uint64_t> path_;  // of each lamp: bit k set where it lies to the right at depth k
  std::vector<uint8_t> depth_;  // of each lamp; 255: not in the tree
};

}  // namespace aktina
