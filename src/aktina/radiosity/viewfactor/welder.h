// Points that are the same but for rounding, and sets that grow together.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

#include "aktina/base/vec.h"

namespace aktina {

/// Numbers points; those nearer than `tolerance` mostly get one number (not across the walls of its cells).
class Welder {
 public:
  explicit Welder(double tolerance) : scale_(1 / tolerance) {}
  uint32_t id(Point3d p) {
    const std::array<int64_t, 3> cell{std::llround(p.x * scale_), std::llround(p.y * scale_),
                                      std::llround(p.z * scale_)};
    return ids_.try_emplace(cell, uint32_t(ids_.size())).first->second;
  }

 private:
  double scale_;
  std::map<std::array<int64_t, 3>, uint32_t> ids_;
};

class DisjointSets {
 public:
  explicit DisjointSets(size_t n) : parents_(n) { std::iota(parents_.begin(), parents_.end(), size_t(0)); }
  size_t find(size_t a) {
    while (parents_[a] != a) a = parents_[a] = parents_[parents_[a]];
    return a;
  }
  void join(size_t a, size_t b) { parents_[find(a)] = find(b); }

 private:
  std::vector<size_t> parents_;
};

}  // namespace aktina
