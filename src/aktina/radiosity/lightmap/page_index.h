// The texels of one page by their place.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "aktina/radiosity/lightmap/coverage.h"

namespace aktina {

class PageIndex {
 public:
  static constexpr uint32_t kNobody = 0xffffffff;

  PageIndex(const LightmapLayout& layout, std::span<const LightmapTexel> texels, int page)
      : texels_(texels), width_(layout.pages[size_t(page)].width), height_(layout.pages[size_t(page)].height) {
    at_.assign(size_t(width_) * size_t(height_), kNobody);
    for (uint32_t i = 0; i < texels.size(); ++i) {
      if (layout.charts[texels[i].chart].page != page) continue;
      at_[texels[i].y * size_t(width_) + texels[i].x] = i;
      here_.push_back(i);
    }
  }

  /// Numbers of the page's texels, in their order.
  const std::vector<uint32_t>& all() const { return here_; }

  /// Calls visit(number, squared distance) for those of the same chart up to `reach` rows and columns away, itself
  /// among them.
  template <class Visit>
  void around(uint32_t i, int reach, const Visit& visit) const {
    const LightmapTexel& t = texels_[i];
    const int cx = int(t.x), cy = int(t.y);
    for (int y = std::max(0, cy - reach); y <= std::min(height_ - 1, cy + reach); ++y)
      for (int x = std::max(0, cx - reach); x <= std::min(width_ - 1, cx + reach); ++x) {
        const uint32_t k = at_[size_t(y) * size_t(width_) + size_t(x)];
        if (k != kNobody && texels_[k].chart == t.chart) visit(k, float((x - cx) * (x - cx) + (y - cy) * (y - cy)));
      }
  }

 private:
  std::span<const LightmapTexel> texels_;
  int width_, height_;
  std::vector<uint32_t> at_, here_;
};

}  // namespace aktina
