#include "aktina/raster/shading/corner_highlight.h"

#include <algorithm>

namespace aktina {
namespace {

/// v, turned as the unit vector `from` is turned onto `to` by the shortest way: I + K + K^2 / (1 + from.to).
Vec3 turned(Vec3 v, Vec3 from, Vec3 to) {
  const float c = dot(from, to);
  if (c < -0.999999f) {  // by half a turn about any axis across
    const Vec3 across = Frame(from).t;
    return 2 * dot(v, across) * across - v;
  }
  const Vec3 k = cross(from, to);
  return v + cross(k, v) + cross(k, cross(k, v)) / (1 + c);
}

}  // namespace

CornerHighlight corner_highlight(const HighlightCurve& curve, const Illuminator& light, size_t lamp, Point3 position,
                                 Vec3 normal) {
  const LightSample s = sample(light.lights()[lamp], position);
  const Vec3 wo = light.viewer().towards(position);
  CornerHighlight out{normal, s.wi, wo, half_vector(s.wi, wo, normal), 0, 0, {}};
  out.cosine = curve.half ? dot(normal, out.half) : dot(reflect_about(normal, s.wi), wo);
  out.facing = dot(normal, s.wi);
  out.peak = light.surface().ks * s.e_perp.v * (float(kInvPi) * light.viewer().cue.at(position));
  return out;
}

CornerHighlights::CornerHighlights(const HighlightCurve& curve, const Illuminator& light, size_t lamp,
                                   const CornerValues& c) {
  for (int v = 0; v < 3; ++v) corner[v] = corner_highlight(curve, light, lamp, c.position[v], c.normal[v]);
}

bool CornerHighlights::dark() const {
  return std::all_of(corner, corner + 3, [](const CornerHighlight& c) { return !(c.facing > 0) || is_black(c.peak); });
}

HighlightPlaces::HighlightPlaces(const HighlightCurve& curve, const CornerHighlights& h) {
  const Vec3 axis = normalize_or(h.corner[0].half + h.corner[1].half + h.corner[2].half, h.corner[0].half);
  const Frame frame(axis);
  for (int v = 0; v < 3; ++v) {
    const CornerHighlight& c = h.corner[v];
    const Vec3 n = frame.to_local(turned(c.normal, c.half, axis));
    corner[v] = n;
    if (curve.half) continue;
    // Phong: 1 - r.v = 2 cos^2 (n.w)^2 + 2 (n.u)^2 with u along l - v, w across u and h, and the cosine of l and h.
    const Vec3 u = frame.to_local(turned(normalize_or(c.to_lamp - c.to_eye, Vec3(0)), c.half, axis));
    const float cosine = dot(c.half, c.to_lamp), along = (1 - cosine) * (n.x * u.x + n.y * u.y);
    constexpr float kRoot2 = 1.41421356f;
    corner[v].x = kRoot2 * (cosine * n.x + along * u.x), corner[v].y = kRoot2 * (cosine * n.y + along * u.y);
  }
}

}  // namespace aktina
