// Euler shading: cosines along a scanline as a parabola whose curvature comes from the exact slopes at its ends, where
// normals are made unit; error-corrected, it is exact at both ends. Spans that bend less than a threshold are
// Gouraud's. Cost: two additions a pixel and cosine; two dot products and a division a span. Weakness: the set-up of
// each span; highlights narrower than a span come out too low. The plain method (corrected=0) misses the right end and
// is worse than Gouraud where normals turn by more than about 30 degrees.
//
// A. Hast, T. Barrera, E. Bengtsson, "Approximated Phong Shading by using the Euler Method", Eurographics 2001.
#include "aktina/raster/shading/euler.h"

#include <algorithm>
#include <cmath>

namespace aktina {

EulerSlopes::EulerSlopes(const TurningPair& v) {
  const Vec3 dp = v.p[1] - v.p[0], dq = v.q[1] - v.q[0];
  for (int e = 0; e < 2; ++e) {
    value[e] = dot(v.p[e], v.q[e]);
    slope[e] = dot(dp, v.q[e]) + dot(v.p[e], dq) - value[e] * (dot(v.p[e], dp) + dot(v.q[e], dq));
  }
}

std::vector<float> euler_recurrence(const EulerSlopes& ends, int steps, bool corrected) {
  const float n = float(steps), ds = ends.bend() / (n * n);
  const float end = ends.value[0] + ends.slope[0] + (n * n - n) / 2 * ds;
  const float error = corrected ? end - ends.value[1] : 0;
  float p = ends.value[0], s = (ends.slope[0] - error) / n;
  std::vector<float> out;
  for (int i = 0; i <= steps; ++i) {
    out.push_back(p);
    p += s, s += ds;
  }
  return out;
}

Quadratics euler_curve(const EulerSlopes& e) {
  const float half = e.bend() / 2;
  return Quadratics::whole(e.value[0], e.value[1] - e.value[0] - half, half);
}

Quadratics plain_euler_curve(const EulerSlopes& e, float steps) {
  const float half = e.bend() / 2;
  return Quadratics::whole(e.value[0], e.slope[0] - half / steps, half);
}

namespace {

class EulerShading final : public CosineShading {
 public:
  EulerShading(bool corrected, float threshold) : CosineShading(linear), corrected_(corrected), threshold_(threshold) {}

 private:
  void light_span(const SpanLight& s, const LitArrays& out) const override {
    add_light(s, curve(s, s.diffuse, 1), curve(s, s.highlight, s.model.exponent), out);
  }

  /// @param exponent  makes errors of the cosine larger by as much
  Quadratics curve(const SpanLight& s, const TurningPair& pair, float exponent) const {
    EulerSlopes ends(pair);
    if (exponent * std::abs(ends.bend()) / 8 < threshold_)
      ends.slope[0] = ends.slope[1] = ends.value[1] - ends.value[0];
    return corrected_ ? euler_curve(ends) : plain_euler_curve(ends, std::max(s.span.right.x - s.span.left.x, 1.0f));
  }

  bool corrected_;
  float threshold_;
};

constexpr Param kParams[] = {
    {"corrected", "1", "1: exact at both ends; 0: the plain method, which misses the right one", 1, 0, 1, true},
    {"threshold", "1", "spans that bend less, as a share of the light, are interpolated linearly", 0.002, 0, 1}};

}  // namespace

extern constinit const ShadingRow euler_shading = {
    {"euler", "Euler shading", "hast2001euler",
     "Cosines along a scanline by two additions a pixel, from their slopes at its ends; linear where they hardly bend.",
     kParams},
    [](const ParamSet& p) -> std::unique_ptr<ShadingMethod> {
      return std::make_unique<EulerShading>(p["corrected"] != 0, float(p["threshold"]));
    }};

}  // namespace aktina
