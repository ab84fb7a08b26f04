#include "aktina/radiosity/lightmap/denoise.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"

namespace aktina {
namespace {

constexpr int kReach = 3;         // texels
constexpr float kDeviations = 3;  // differences of so many standard deviations weigh 1 / e
constexpr uint32_t kNobody = 0xffffffff;

/// Texels of one page by their place.
class PageIndex {
 public:
  PageIndex(const LightmapLayout& layout, std::span<const LightmapTexel> texels, int page)
      : width_(layout.pages[size_t(page)].width), height_(layout.pages[size_t(page)].height) {
    at_.assign(size_t(width_) * size_t(height_), kNobody);
    for (uint32_t i = 0; i < texels.size(); ++i)
      if (layout.charts[texels[i].chart].page == page) at_[texels[i].y * size_t(width_) + texels[i].x] = i;
  }
  template <class Visit>
  void around(const LightmapTexel& t, const Visit& visit) const {
    for (int y = std::max(0, int(t.y) - kReach); y <= std::min(height_ - 1, int(t.y) + kReach); ++y)
      for (int x = std::max(0, int(t.x) - kReach); x <= std::min(width_ - 1, int(t.x) + kReach); ++x)
        if (const uint32_t i = at_[size_t(y) * size_t(width_) + size_t(x)]; i != kNobody)
          visit(i, float((x - int(t.x)) * (x - int(t.x)) + (y - int(t.y)) * (y - int(t.y))));
  }

 private:
  int width_, height_;
  std::vector<uint32_t> at_;
};

/// The variance over neighbours: single texels know their own badly.
float variance_about(const PageIndex& index, std::span<const LightmapTexel> texels, const TexelLight& light, size_t i) {
  double sum = 0, weights = 0;
  index.around(texels[i], [&](uint32_t k, float squared) {
    if (squared > 2 || texels[k].chart != texels[i].chart) return;
    const double weight = squared == 0 ? 4 : squared == 1 ? 2 : 1;
    sum += weight * double(light.variances[k]), weights += weight;
  });
  return float(sum / weights);
}

}  // namespace

void denoise(const LightmapLayout& layout, std::span<const LightmapTexel> texels, TexelLight& light) {
  if (light.variances.empty()) return;
  std::vector<Rgb> smooth = light.irradiances;
  std::vector<Vec3> normals(texels.size());
  parallel_for(texels.size(), 4096, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) normals[i] = texel_point(layout, texels[i], {texels[i].u, texels[i].v}).normal;
  });
  for (int page = 0; page < int(layout.pages.size()); ++page) {
    const PageIndex index(layout, texels, page);
    parallel_for(texels.size(), 1024, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        if (layout.charts[texels[i].chart].page != page || !(light.variances[i] > 0)) continue;
        const float own = variance_about(index, texels, light, i), mine = luminance(light.irradiances[i]);
        Rgb sum;
        float weights = 0;
        index.around(texels[i], [&](uint32_t k, float squared) {
          if (texels[k].chart != texels[i].chart) return;
          const float gap = luminance(light.irradiances[k]) - mine;
          const float noise = kDeviations * kDeviations * (own + light.variances[k]);
          const float facing = std::max(0.0f, dot(normals[i], normals[k]));
          const float weight =
              std::exp(-squared / float(kReach * kReach) - gap * gap / noise) * std::pow(facing, 32.0f);
          sum += weight * light.irradiances[k], weights += weight;
        });
        if (weights > 0) smooth[i] = sum / weights;
      }
    });
  }
  light.irradiances = std::move(smooth);
}

}  // namespace aktina
