// Local maximal specular estimation: along a scanline the highest cosine of a highlight, and where it is, are known in
// closed form; two parabolas lead from it to the ends, level at the top. Highlights inside a span keep their height.
// Spans without a maximum inside, and the diffuse light, are Euler's parabola. Cost: two additions a pixel and cosine,
// and the power; a square root and a division a span. Weakness: the set-up of each span; a highlight is a little too
// wide. The paper could not be read in full: this is a reconstruction.
//
// In the manner of Lin et al., "Local maximal specular estimation", 2002.
#include <algorithm>
#include <cmath>

#include "aktina/raster/shading/lin.h"

namespace aktina {

std::optional<SpanPeak> span_peak(const CombinedPair& pair) {
  const Arc& arc = pair.arc;
  const float a = dot(arc.a, pair.target), b = dot(arc.at(1), pair.target), c = std::cos(arc.angle);
  const float from_left = b - a * c, from_right = a - b * c;
  if (!(from_left > 1e-6f && from_right > 1e-6f)) return std::nullopt;
  const float beside = dot(pair.target, cross(arc.a, arc.tangent));
  return SpanPeak{from_left / (from_left + from_right), std::sqrt(std::max(1 - beside * beside, 0.0f)), a, b};
}

Quadratics peak_curve(const SpanPeak& p) {
  const float left = (p.value - p.left) / (p.t * p.t), right = (p.value - p.right) / ((1 - p.t) * (1 - p.t));
  return {p.t,
          {p.left, 2 * left * p.t, -left},  // peak - (peak - left) ((t* - t) / t*)^2
          {p.value - right * p.t * p.t, 2 * right * p.t, -right}};
}

namespace {

class LinShading final : public CosineShading {
 public:
  LinShading() : CosineShading(linear) {}

 private:
  void light_span(const SpanLight& s, const LitArrays& out) const override {
    const auto peak = span_peak(CombinedPair(s.highlight));
    add_light(s, euler_curve(EulerSlopes(s.diffuse)), peak ? peak_curve(*peak) : euler_curve(EulerSlopes(s.highlight)),
              out);
  }
};

}  // namespace

extern constinit const ShadingRow lin_shading = {
    {"lin", "Local maximal specular estimation", "lin2002",
     "Parabolas from the highest cosine on a scanline to its ends: highlights inside a span keep their height."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<LinShading>(); }};

}  // namespace aktina
