// The directional albedo of GGX facets, integrated once into a small table.
#include <algorithm>
#include <array>
#include <cmath>

#include "aktina/base/random.h"
#include "aktina/illumination/ggx.h"
#include "aktina/trace/scattering.h"

namespace aktina {
namespace {

constexpr int kSize = 32;  // of the table, in the cosine and in sqrt(alpha)
constexpr uint32_t kSamples = 512;

/// Mean over facets that wo sees of G2 / G1, split by Schlick's weight.
FacetAlbedo integrate(float alpha, float cosine) {
  const Vec3 wo(std::sqrt(std::max(0.0f, 1 - cosine * cosine)), 0, cosine);
  double scale = 0, bias = 0;
  for (uint32_t i = 0; i < kSamples; ++i) {
    const Vec3 h = sample_ggx_normal(alpha, wo, sobol_owen(i, 1));
    const float c = dot(wo, h);
    const Vec3 wi = h * (2 * c) - wo;
    if (!(wi.z > 0)) continue;
    const float shadowing = 4 * cosine * wi.z * ggx_visibility(alpha, wi.z, cosine) / ggx_masking(alpha, cosine);
    const float f = schlick_weight(c);
    scale += double(shadowing * (1 - f)), bias += double(shadowing * f);
  }
  return {float(scale / kSamples), float(bias / kSamples)};
}

struct Table {
  std::array<std::array<FacetAlbedo, kSize>, kSize> at;  // [alpha][cosine]
  std::array<FacetAlbedo, kSize> mean;

  Table() {
    for (size_t i = 0; i < kSize; ++i) {
      const float root = float(i) / (kSize - 1), alpha = std::max(root * root, 1e-4f);
      double scale = 0, bias = 0, weight = 0;
      for (size_t j = 0; j < kSize; ++j) {
        const float cosine = std::max(float(j) / (kSize - 1), 1e-3f);
        at[i][j] = integrate(alpha, cosine);
        const double w = double(cosine) * (j == 0 || j == kSize - 1 ? 0.5 : 1);
        scale += w * double(at[i][j].scale), bias += w * double(at[i][j].bias), weight += w;
      }
      mean[i] = {float(scale / weight), float(bias / weight)};
    }
  }
};

const Table& table() {
  static const Table table;
  return table;
}

struct Cell {
  size_t index;
  float rest;
  explicit Cell(float unit) {
    const float x = std::clamp(unit, 0.0f, 1.0f) * (kSize - 1);
    index = std::min(size_t(x), size_t(kSize - 2));
    rest = x - float(index);
  }
};

FacetAlbedo mix(FacetAlbedo a, FacetAlbedo b, float t) {
  return {a.scale + (b.scale - a.scale) * t, a.bias + (b.bias - a.bias) * t};
}

}  // namespace

FacetAlbedo facet_albedo(float alpha, float cosine) {
  const Cell a(std::sqrt(alpha)), c(cosine);
  const auto& t = table().at;
  return mix(mix(t[a.index][c.index], t[a.index][c.index + 1], c.rest),
             mix(t[a.index + 1][c.index], t[a.index + 1][c.index + 1], c.rest), a.rest);
}

FacetAlbedo mean_facet_albedo(float alpha) {
  const Cell a(std::sqrt(alpha));
  return mix(table().mean[a.index], table().mean[a.index + 1], a.rest);
}

}  // namespace aktina
