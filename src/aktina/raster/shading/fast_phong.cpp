// Fast Phong shading: the cosines of normal and lamp, and of the highlight, as polynomials of second degree on each
// triangle, the Taylor series about its centre of what linear interpolation and normalisation give. Cost: two additions
// a pixel for the diffuse light, five and a power (or table) with the highlight; a set-up a triangle and lamp.
// Weakness: not continuous across edges: the error grows with the third power of the triangle's size; highlights on
// large triangles are lost or out of place.
//
// The paper's lamp and viewer are infinitely far away; where they are not, their directions are linear on the triangle
// too, and belong to the series.
//
// G. Bishop, D. M. Weimer, "Fast Phong Shading", SIGGRAPH 1986.
#include "aktina/raster/shading/fast_phong.h"

#include <algorithm>
#include <cmath>

namespace aktina {

Taylor2 operator*(const Taylor2& a, const Taylor2& b) {
  return {a.c * b.c,
          a.c * b.x + a.x * b.c,
          a.c * b.y + a.y * b.c,
          a.c * b.xx + a.x * b.x + a.xx * b.c,
          a.c * b.xy + a.x * b.y + a.y * b.x + a.xy * b.c,
          a.c * b.yy + a.y * b.y + a.yy * b.c};
}

Taylor2 operator*(double s, const Taylor2& a) { return {s * a.c, s * a.x, s * a.y, s * a.xx, s * a.xy, s * a.yy}; }

Taylor2 operator-(const Taylor2& a, const Taylor2& b) {
  return {a.c - b.c, a.x - b.x, a.y - b.y, a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
}

Taylor2 inverse_sqrt(const Taylor2& a) {
  Taylor2 u = (1 / a.c) * a;  // 1 + u: (1 + u)^(-1/2) = 1 - u / 2 + 3 / 8 u^2
  u.c = 0;
  Taylor2 series = (3.0 / 8) * (u * u) - 0.5 * u;
  series.c = 1;
  return (1 / std::sqrt(a.c)) * series;
}

LinearVector linear_vector(const Vec2 (&screen)[3], const Vec3 (&values)[3]) {
  const Vec2d e1 = Vec2d(screen[1]) - Vec2d(screen[0]), e2 = Vec2d(screen[2]) - Vec2d(screen[0]);
  const double area = e1.x * e2.y - e1.y * e2.x;
  const Vec3d d1 = Vec3d(values[1]) - Vec3d(values[0]), d2 = Vec3d(values[2]) - Vec3d(values[0]);
  return {(d1 * e2.y - d2 * e1.y) / area, (d2 * e1.x - d1 * e2.x) / area,
          (Vec3d(values[0]) + Vec3d(values[1]) + Vec3d(values[2])) / 3.0};
}

Taylor2 dot(const LinearVector& a, const LinearVector& b) {
  return {dot(a.c, b.c), dot(a.x, b.c) + dot(a.c, b.x), dot(a.y, b.c) + dot(a.c, b.y),
          dot(a.x, b.x), dot(a.x, b.y) + dot(a.y, b.x), dot(a.y, b.y)};
}

Taylor2 cosine_series(const LinearVector& a, const LinearVector& b) {
  return dot(a, b) * inverse_sqrt(dot(a, a)) * inverse_sqrt(dot(b, b));
}

std::array<double, 6> bishop_weimer_terms(const LinearVector& n, Vec3d light) {
  const double a = dot(light, n.x), b = dot(light, n.y), c = dot(light, n.c);
  const double d = dot(n.x, n.x), e = 2 * dot(n.x, n.y), f = dot(n.y, n.y);
  const double g = 2 * dot(n.x, n.c), h = 2 * dot(n.y, n.c), i = dot(n.c, n.c), s = std::sqrt(i);
  return {c / s,
          (2 * b * i - c * h) / (2 * i * s),
          (2 * a * i - c * g) / (2 * i * s),
          (3 * c * h * h - 4 * c * f * i - 4 * b * h * i) / (8 * i * i * s),
          (3 * c * g * h - 2 * c * e * i - 2 * b * g * i - 2 * a * h * i) / (4 * i * i * s),
          (3 * c * g * g - 4 * c * d * i - 4 * a * g * i) / (8 * i * i * s)};
}

std::vector<double> forward_differences(const Taylor2& t, double x, double y, int count) {
  std::vector<double> out;
  double value = t.at(x, y), step = t.xx * (2 * x + 1) + t.xy * y + t.x;
  for (int i = 0; i < count; ++i) {
    out.push_back(value);
    value += step, step += 2 * t.xx;
  }
  return out;
}

namespace {

/// A triangle on the screen with what its corners know.
struct Corners {
  Vec2 screen[3], centre;
  Point3 position[3];
  float cue[3];  // DepthCue
  LinearVector normal, viewer;

  Corners(const TriangleGroup& t, int lane, const Viewer& from) {
    const auto i = size_t(lane);
    Vec3 n[3], v[3];
    for (int k = 0; k < 3; ++k) {
      screen[k] = {t.screen[k][0][i], t.screen[k][1][i]};
      position[k] = {t.position[k][0][i], t.position[k][1][i], t.position[k][2][i]};
      n[k] = {t.normal[k][0][i], t.normal[k][1][i], t.normal[k][2][i]};
      v[k] = from.towards(position[k]);
      cue[k] = from.cue.at(position[k]);
    }
    centre = (screen[0] + screen[1] + screen[2]) / 3.0f;
    normal = steady(linear_vector(screen, n), n[0]), viewer = steady(linear_vector(screen, v), v[0]);
  }

  /// Directions that cancel out at the centre have no series there: that of a corner takes their place.
  static LinearVector steady(const LinearVector& v, Vec3 corner) {
    return squared_length(v.c) > 1e-4 ? v : LinearVector{Vec3d(0), Vec3d(0), Vec3d(corner)};
  }
};

/// One lamp on one triangle.
struct LampSeries {
  LinearVector arriving;  // E / pi: red, green, blue
  Taylor2 diffuse, highlight;

  LampSeries(const Corners& t, const Light& light, const CosineModel& model) {
    Vec3 wi[3], e[3];
    for (int k = 0; k < 3; ++k) {
      const LightSample s = sample(light, t.position[k]);
      wi[k] = s.wi;
      e[k] = Vec3(s.e_perp.v.r, s.e_perp.v.g, s.e_perp.v.b) * (float(kInvPi) * t.cue[k]);
    }
    arriving = linear_vector(t.screen, e);
    const LinearVector l = Corners::steady(linear_vector(t.screen, wi), wi[0]);
    diffuse = cosine_series(t.normal, l);
    if (model.highlight == CosineModel::Highlight::normal_half) {
      highlight = cosine_series(t.normal, Corners::steady(sum(l, t.viewer), Vec3(t.normal.c)));
    } else {  // r.v = 2 (n.l)(n.v) - l.v
      highlight = 2 * (diffuse * cosine_series(t.normal, t.viewer)) - cosine_series(l, t.viewer);
    }
  }

  static LinearVector sum(const LinearVector& a, const LinearVector& b) { return {a.x + b.x, a.y + b.y, a.c + b.c}; }

  Rgb arriving_at(double x, double y) const {
    const Vec3d e = arriving.x * x + arriving.y * y + arriving.c;
    return {float(e.x), float(e.y), float(e.z)};
  }
};

class FastPhongShading final : public ShadingMethod {
 public:
  ShadingPlan plan(const Illuminator& light) const override {
    cosine_model(light);
    return {.kind = ShadingPlan::Kind::spans, .needs = ShadingPlan::kPosition | ShadingPlan::kNormal};
  }

  void shade_spans(const TriangleGroup& triangles, int lane, std::span<const Span> spans, const Illuminator& light,
                   const LitArrays& out) const override {
    const CosineModel model = cosine_model(light);
    const Corners corners(triangles, lane, light.viewer());
    const Rgb ambient = light.surface().ka * light.ambient();
    for (const Span& span : spans)
      if (light.lights().empty()) fill_ambient(span, ambient, out);
    for (const Light& lamp : light.lights()) {
      const LampSeries series(corners, lamp, model);
      for (const Span& span : spans) {
        const double x = span.left.x - corners.centre.x, y = span.y - corners.centre.y;
        const double across = span.right.x - span.left.x;
        const SpanLight s{span,
                          model,
                          light.surface().kd,
                          light.surface().ks,
                          &lamp == light.lights().data(),
                          ambient,
                          {series.arriving_at(x, y), series.arriving_at(x + across, y)},
                          {},
                          {}};
        add_light(s, on_scanline(series.diffuse, x, y, across), on_scanline(series.highlight, x, y, across), out);
      }
    }
  }

 private:
  static Quadratics on_scanline(const Taylor2& t, double x, double y, double across) {
    return Quadratics::whole(float(t.at(x, y)), float((t.x + 2 * t.xx * x + t.xy * y) * across),
                             float(t.xx * across * across));
  }
};

}  // namespace

extern constinit const ShadingRow fast_phong_shading = {
    {"fast_phong", "Fast Phong shading", "bishop1986",
     "Cosines to second order about each triangle's centre: two additions a pixel; not continuous across edges."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<FastPhongShading>(); }};

}  // namespace aktina
