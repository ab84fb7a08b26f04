#include "aktina/raster/shading/shading_method.h"

#include <cassert>

namespace aktina {
namespace {

using Bary = std::array<float, 3>;
constexpr float k1 = 1.0f / 3, k2 = 2.0f / 3;
constexpr Bary kLattice[] = {
    {k1, k1, k1},                                                                               // degree 0
    {1, 0, 0},    {0, 1, 0},   {0, 0, 1},                                                       // 1
    {1, 0, 0},    {0, 1, 0},   {0, 0, 1},   {0.5f, 0.5f, 0}, {0, 0.5f, 0.5f}, {0.5f, 0, 0.5f},  // 2
    {1, 0, 0},    {0, 1, 0},   {0, 0, 1},   {k2, k1, 0},     {k1, k2, 0},     {0, k2, k1},      // 3
    {0, k1, k2},  {k1, 0, k2}, {k2, 0, k1}, {k1, k1, k1},
};

}  // namespace

std::span<const std::array<float, 3>> lattice(int degree) {
  constexpr size_t kFirst[] = {0, 1, 4, 10}, kCount[] = {1, 3, 6, 10};
  return std::span(kLattice).subspan(kFirst[degree], kCount[degree]);
}

void TriangleGroup::interpolate(const Lanes (&vertices)[3][3], const std::array<float, 3>& barycentric,
                                bool perspective, Lanes (&out)[3]) const {
  for (size_t i = 0; i < kLanes; ++i) {
    float b[3], sum = 0;
    for (int v = 0; v < 3; ++v) sum += b[v] = barycentric[size_t(v)] * (perspective ? 1 : weight[v][i]);
    for (int k = 0; k < 3; ++k)
      out[k][i] = (b[0] * vertices[0][k][i] + b[1] * vertices[1][k][i] + b[2] * vertices[2][k][i]) / sum;
  }
}

void Samples::store(int point, const Lanes (&diffuse)[3], const Lanes (&specular)[3]) const {
  for (int k = 0; k < 3; ++k) {
    if (channels_ == 6) {
      (*this)(point, k) = diffuse[k];
      (*this)(point, 3 + k) = specular[k];
    } else {
      for (size_t i = 0; i < kLanes; ++i) (*this)(point, k)[i] = diffuse[k][i] + specular[k][i];
    }
  }
}

void Fragments::diffuse_of(const float* const* radiance, const Illuminator& light, const LitArrays& out) const {
  for (int k = 0; k < 3; ++k)
    for (size_t i = 0; i < count; ++i)
      out.diffuse[k][i] =
          surface ? surface->ka[k][i] * light.ambient()[k] + surface->kd[k][i] * radiance[k][i] : radiance[k][i];
}

void ShadingMethod::prepare(const TriangleGroup&, const Illuminator&, const Samples&) const { assert(false); }
void ShadingMethod::shade(const Fragments&, const Illuminator&, const LitArrays&) const { assert(false); }
void ShadingMethod::shade_spans(const TriangleGroup&, int, std::span<const Span>, const Illuminator&,
                                const LitArrays&) const {
  assert(false);
}

}  // namespace aktina
