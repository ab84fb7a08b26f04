// Which of many boxes touch another: a binary tree of boxes, halved at the median.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aktina/base/function_ref.h"
#include "aktina/base/vec.h"

namespace aktina {

class BoxTree {
 public:
  explicit BoxTree(std::span<const Bounds> boxes);
  /// Calls body(i) for every box that touches `box`, always in the same order.
  void touching(const Bounds& box, FunctionRef<void(uint32_t)> body) const;

 private:
  struct Node {
    Bounds box;
    uint32_t first, count;  // of order_; the left child follows its parent
    uint32_t right;         // 0: a leaf
  };
  uint32_t build(uint32_t first, uint32_t count);

  std::span<const Bounds> boxes_;
  std::vector<uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace aktina
