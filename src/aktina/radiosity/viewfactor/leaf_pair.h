// Two leaves, looked at together: which of their fragments see each other, and what stands between.
#pragma once

#include <algorithm>

#include "aktina/radiosity/viewfactor/blockers.h"
#include "aktina/radiosity/viewfactor/leaves.h"

namespace aktina {

/// Heights of the corners of a leaf's fragments over the bounds of one blocker.
class LaneHeights {
 public:
  void set(const Leaf& leaf, const Blocker& blocker, double tolerance);
  /// Bounds that have the whole fragment on their outside, as bits.
  uint32_t outside(size_t lane) const { return outside_[lane]; }
  /// [bound][4 corners][16 fragments]; their sign is that of the numbers in double precision.
  const float* data() const { return heights_.data(); }
  float height(size_t lane, size_t corner, size_t bound) const { return heights_[(4 * bound + corner) * kLeaf + lane]; }

 private:
  std::array<uint32_t, kLeaf> outside_{};
  std::vector<float> heights_;
};

/// Whether a blocker stops all light between two convex sets, each given by its corners' heights over the bounds: then
/// it stops all segments between corners, and, shadows of convex sets being convex, all others. height_a(corner,
/// bound), height_b(corner, bound)
template <class HeightA, class HeightB>
bool blocks_all(size_t corners_a, size_t corners_b, const Blocker& blocker, double tolerance, HeightA&& height_a,
                HeightB&& height_b) {
  // A segment that ends in the surface of the blocker is not stopped by it; one that passes an edge is.
  const size_t surface = blocker.closed ? blocker.bounds.size() : 2;
  for (size_t p = 0; p < corners_a; ++p)
    for (size_t q = 0; q < corners_b; ++q) {
      double from = 0, to = 1;
      for (size_t k = 0; k < blocker.bounds.size(); ++k) {
        const double a = height_a(p, k), b = height_b(q, k), outside = k < surface ? -tolerance : tolerance;
        if (a > outside && b > outside) return false;
        if (a > 0 && b <= 0)
          from = std::max(from, a / (a - b));
        else if (b > 0 && a <= 0)
          to = std::min(to, a / (a - b));
        if (from > to + 1e-12) return false;
      }
    }
  return true;
}

/// Which blockers may stand between two leaves.
struct LeafView {
  bool facing = false, blocked = false;
  bool crowded = false;  // so many are near that they have not been looked at
  bool entered = false;  // one of them may reach through one of the leaves: single precision is not enough beside it
  std::vector<uint32_t> candidates;
};
void look_between(const Leaf& a, const Leaf& b, const BlockerTree& blockers, double tolerance, LeafView& view);

}  // namespace aktina
