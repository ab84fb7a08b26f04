#include "aktina/radiosity/lightmap/pack.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

namespace aktina {
namespace {

/// The upper outline of what lies on a page.
class Skyline {
 public:
  explicit Skyline(int size) : size_(size), steps_{{0, size, 0}} {}

  bool add(PackedBox& box) {
    if (box.width >= refused_width_ && box.height >= refused_height_) return false;
    const std::optional<Spot> spot = lowest(box);
    if (!spot) {
      refused_width_ = box.width, refused_height_ = box.height;
      return false;
    }
    box.x = steps_[spot->step].x, box.y = spot->y;
    raise(spot->step, box);
    return true;
  }

 private:
  struct Step {
    int x, width, y;
  };
  struct Spot {
    size_t step;
    int y;
  };

  std::optional<Spot> lowest(const PackedBox& box) const {
    std::optional<Spot> best;
    for (size_t i = 0; i < steps_.size() && steps_[i].x + box.width <= size_; ++i) {
      const int limit = best ? best->y : size_ - box.height + 1;
      if (steps_[i].y >= limit) continue;
      int y = 0;
      for (size_t k = i; k < steps_.size() && steps_[k].x < steps_[i].x + box.width && y < limit; ++k)
        y = std::max(y, steps_[k].y);
      if (y < limit) best = Spot{i, y};
    }
    return best;
  }

  void raise(size_t at, const PackedBox& box) {
    const int end = box.x + box.width;
    size_t last = at;
    while (last < steps_.size() && steps_[last].x + steps_[last].width <= end) ++last;
    if (last < steps_.size() && steps_[last].x < end) steps_[last].width -= end - steps_[last].x, steps_[last].x = end;
    steps_.erase(steps_.begin() + std::ptrdiff_t(at), steps_.begin() + std::ptrdiff_t(last));
    steps_.insert(steps_.begin() + std::ptrdiff_t(at), Step{box.x, box.width, box.y + box.height});
    join(at);
    if (at > 0) join(at - 1);
  }
  void join(size_t at) {
    if (at + 1 >= steps_.size() || steps_[at].y != steps_[at + 1].y) return;
    steps_[at].width += steps_[at + 1].width;
    steps_.erase(steps_.begin() + std::ptrdiff_t(at) + 1);
  }

  int size_, refused_width_ = size_ + 1, refused_height_ = size_ + 1;  // what is as large does not fit either
  std::vector<Step> steps_;                                            // from left to right
};

}  // namespace

int pack(std::span<PackedBox> boxes, int page_size, int most_pages) {
  std::vector<uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return boxes[a].height != boxes[b].height ? boxes[a].height > boxes[b].height : boxes[a].width > boxes[b].width;
  });
  std::vector<Skyline> pages;
  for (const uint32_t i : order) {
    size_t page = 0;
    while (page < pages.size() && !pages[page].add(boxes[i])) ++page;
    if (page == pages.size()) {
      if (int(page) == most_pages) return 0;
      pages.emplace_back(page_size);
      if (!pages.back().add(boxes[i])) return 0;
    }
    boxes[i].page = int(page);
  }
  return int(pages.size());
}

}  // namespace aktina
