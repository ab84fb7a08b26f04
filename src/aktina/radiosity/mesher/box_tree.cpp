#include "aktina/radiosity/mesher/box_tree.h"

#include <algorithm>
#include <numeric>

namespace aktina {
namespace {

constexpr uint32_t kLeaf = 4;

bool touch(const Bounds& a, const Bounds& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

}  // namespace

BoxTree::BoxTree(std::span<const Bounds> boxes) : boxes_(boxes), order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!boxes.empty()) build(0, uint32_t(boxes.size()));
}

uint32_t BoxTree::build(uint32_t first, uint32_t count) {
  const auto at = uint32_t(nodes_.size());
  Bounds box, middles;
  for (uint32_t i = first; i < first + count; ++i) box.add(boxes_[order_[i]]), middles.add(boxes_[order_[i]].centre());
  nodes_.push_back({box, first, count, 0});
  if (count <= kLeaf) return at;
  const Vec3 size = middles.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](uint32_t a, uint32_t b) {
    const float p = boxes_[a].centre()[axis], q = boxes_[b].centre()[axis];
    return p != q ? p < q : a < b;
  });
  build(first, count / 2);
  nodes_[at].right = build(first + count / 2, count - count / 2);
  return at;
}

void BoxTree::touching(const Bounds& box, FunctionRef<void(uint32_t)> body) const {
  uint32_t open[64];
  int depth = 0;
  if (!nodes_.empty()) open[depth++] = 0;
  while (depth > 0) {
    const uint32_t at = open[--depth];
    const Node& node = nodes_[at];
    if (!touch(node.box, box)) continue;
    if (node.right != 0) {
      open[depth++] = node.right, open[depth++] = at + 1;
      continue;
    }
    for (uint32_t i = node.first; i < node.first + node.count; ++i)
      if (touch(boxes_[order_[i]], box)) body(order_[i]);
  }
}

}  // namespace aktina
