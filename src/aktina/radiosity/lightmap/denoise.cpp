#include "aktina/radiosity/lightmap/denoise.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/radiosity/lightmap/page_index.h"

namespace aktina {
namespace {

constexpr int kReach = 3;         // texels
constexpr float kDeviations = 3;  // differences of so many standard deviations weigh 1 / e

/// The variance over neighbours: single texels know their own badly.
float variance_about(const PageIndex& index, const TexelLight& light, uint32_t i) {
  double sum = 0, weights = 0;
  index.around(i, 1, [&](uint32_t k, float squared) {
    const double weight = squared == 0 ? 4 : squared == 1 ? 2 : 1;
    sum += weight * double(light.variances[k]), weights += weight;
  });
  return float(sum / weights);
}

Rgb smoothed(const PageIndex& index, const TexelLight& light, const std::vector<Vec3>& normals, uint32_t i) {
  const float own = variance_about(index, light, i), mine = luminance(light.irradiances[i]);
  Rgb sum;
  float weights = 0;
  index.around(i, kReach, [&](uint32_t k, float squared) {
    if (light.useless(k)) return;
    const float gap = luminance(light.irradiances[k]) - mine;
    const float noise = kDeviations * kDeviations * (own + light.variances[k]);
    const float facing = std::max(0.0f, dot(normals[i], normals[k]));
    const float weight = std::exp(-squared / float(kReach * kReach) - gap * gap / noise) * std::pow(facing, 32.0f);
    sum += weight * light.irradiances[k], weights += weight;
  });
  return weights > 0 ? sum / weights : light.irradiances[i];
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
    parallel_for(index.all().size(), 1024, [&](size_t begin, size_t end) {
      for (size_t n = begin; n < end; ++n)
        if (const uint32_t i = index.all()[n]; light.variances[i] > 0 && !light.useless(i))
          smooth[i] = smoothed(index, light, normals, i);
    });
  }
  light.irradiances = std::move(smooth);
}

}  // namespace aktina
