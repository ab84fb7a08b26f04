// Values of texels -> texels about them that have none.
#include <algorithm>

#include "aktina/radiosity/lightmap/coverage.h"

namespace aktina {
namespace {

constexpr uint32_t kNobody = 0xffffffff;

/// Cells of a grid that wait for a value, in rounds: those next to cells that have one are filled together.
class Rounds {
 public:
  /// @param known  by cell. @param joined  whether a value may pass from one cell to another
  Rounds(int width, int height, std::vector<uint8_t> known)
      : width_(width), height_(height), known_(std::move(known)) {}

  template <class Joined, class Value, class Set>
  void run(const Joined& joined, const Value& value, const Set& set) {
    std::vector<uint32_t> next;
    for (uint32_t i = 0; i < known_.size(); ++i)
      if (!known_[i] && borders(i, joined)) next.push_back(i);
    std::vector<std::pair<uint32_t, Rgb>> fresh;
    while (!next.empty()) {
      fresh.clear();
      for (const uint32_t i : next) {
        Rgb sum;
        int count = 0;
        around(i, [&](uint32_t k) {
          if (known_[k] && joined(i, k)) sum += value(k), ++count;
        });
        fresh.emplace_back(i, sum / float(count));
      }
      for (const auto& [i, mean] : fresh) set(i, mean), known_[i] = 1;
      next.clear();
      for (const auto& [i, mean] : fresh)
        around(i, [&, from = i](uint32_t k) {
          if (!known_[k] && joined(from, k)) next.push_back(k);
        });
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
    }
  }

 private:
  template <class Visit>
  void around(uint32_t i, const Visit& visit) const {
    const int x = int(i % uint32_t(width_)), y = int(i / uint32_t(width_));
    for (int b = std::max(0, y - 1); b <= std::min(height_ - 1, y + 1); ++b)
      for (int a = std::max(0, x - 1); a <= std::min(width_ - 1, x + 1); ++a)
        if (a != x || b != y) visit(uint32_t(b) * uint32_t(width_) + uint32_t(a));
  }
  template <class Joined>
  bool borders(uint32_t i, const Joined& joined) const {
    bool found = false;
    around(i, [&](uint32_t k) { found = found || (known_[k] && joined(i, k)); });
    return found;
  }

  int width_, height_;
  std::vector<uint8_t> known_;
};

}  // namespace

void spread(Image& image, std::vector<uint8_t> known) {
  const auto at = [&](uint32_t i) { return image.pixels.data() + size_t(i) * 3; };
  Rounds(image.width, image.height, std::move(known))
      .run([](uint32_t, uint32_t) { return true; }, [&](uint32_t i) { return Rgb(at(i)[0], at(i)[1], at(i)[2]); },
           [&](uint32_t i, Rgb v) { at(i)[0] = v.r, at(i)[1] = v.g, at(i)[2] = v.b; });
}

void replace_useless(const LightmapLayout& layout, std::span<const LightmapTexel> texels,
                     const std::vector<uint8_t>& useless, std::vector<Rgb>& values) {
  for (int page = 0; page < int(layout.pages.size()); ++page) {
    const auto [width, height] = layout.pages[size_t(page)];
    std::vector<uint32_t> texel_at(size_t(width) * size_t(height), kNobody);
    std::vector<uint8_t> known(texel_at.size(), 1);  // cells without a texel want no value
    for (uint32_t i = 0; i < texels.size(); ++i) {
      if (layout.charts[texels[i].chart].page != page) continue;
      const size_t cell = texels[i].y * size_t(width) + texels[i].x;
      texel_at[cell] = i, known[cell] = !useless[i];
    }
    const auto joined = [&](uint32_t a, uint32_t b) {
      const uint32_t s = texel_at[a], t = texel_at[b];
      return s != kNobody && t != kNobody && texels[s].chart == texels[t].chart;
    };
    Rounds(width, height, std::move(known))
        .run(
            joined, [&](uint32_t i) { return values[texel_at[i]]; },
            [&](uint32_t i, Rgb v) { values[texel_at[i]] = v; });
  }
}

}  // namespace aktina
