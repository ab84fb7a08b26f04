#include <algorithm>
#include <cmath>

#include "aktina/raster/shading/angular.h"

namespace aktina {
namespace {

/// Angle of a unit vector with this sine and cosine, 0 .. pi, absolute error 3e-7: an arc tangent that is found for
/// each lamp on each span. The polynomial is that of arc_tangent_ratio() in base/simd.h.
float angle_of(float sine, float cosine) {
  const float c = std::abs(cosine), high = std::max(sine, c);
  if (!(high > 0)) return 0;
  const float t = std::min(sine, c) / high, q = t * t;
  float p = -4.693276624e-3f * q + 2.425241284e-2f;
  p = p * q - 5.948641916e-2f;
  p = p * q + 9.914295705e-2f;
  p = p * q - 1.401948246e-1f;
  p = p * q + 1.996972430e-1f;
  p = p * q - 3.333199079e-1f;
  p = p * q + 9.999999010e-1f;
  const float acute = sine > c ? float(kPi / 2) - p * t : p * t;
  return cosine < 0 ? float(kPi) - acute : acute;
}

/// Turns v as the smallest turn does that takes unit vector `from` to `to`.
Vec3 turned(Vec3 v, Vec3 from, Vec3 to) {
  if (from == to) return v;
  const Vec3 k = cross(from, to);
  const float c = dot(from, to);
  return normalize_or(v * c + cross(k, v) + k * (dot(k, v) / std::max(1 + c, 1e-6f)), v);
}

float kuijk_inner(float n) { return (n + 5.6f) / (n * (0.09f * n + 5.2f)); }
float kuijk_outer(float n) { return (n + 65) / (5 * n + 31.7f); }

}  // namespace

Arc::Arc(Vec3 from, Vec3 to) : a(from) {
  const Vec3 across = to - from * dot(from, to);
  const float sine = length(across);
  angle = angle_of(sine, dot(from, to));
  // Where they (nearly) agree or are opposite, what is left is rounding error: any direction at right angles will do.
  const Vec3 unit = normalize_or(across, Vec3(0));
  tangent = sine > 1e-6f ? normalize_or(unit - from * dot(from, unit), Frame(from).t) : Frame(from).t;
}

Vec3 Arc::at(float t) const { return std::cos(angle * t) * a + std::sin(angle * t) * tangent; }

Vec3 slerp(Vec3 a, Vec3 b, float t) { return Arc(a, b).at(t); }

std::vector<Vec3> arc_recurrence(const Arc& arc, int steps) {
  const double delta = double(arc.angle) / steps, twice = 2 * std::cos(delta);
  Vec3d now(arc.a), before = Vec3d(arc.a) * std::cos(delta) - Vec3d(arc.tangent) * std::sin(delta);
  std::vector<Vec3> out;
  for (int i = 0; i <= steps; ++i) {
    out.emplace_back(now);
    const Vec3d next = twice * now - before;
    before = now, now = next;
  }
  return out;
}

Waves turning_cosine(const TurningPair& v) {
  const Arc p(v.p[0], v.p[1]), q(v.q[0], v.q[1]);
  const float aa = dot(p.a, q.a), at = dot(p.a, q.tangent), ta = dot(p.tangent, q.a), tt = dot(p.tangent, q.tangent);
  if (v.q[0] == v.q[1]) return {{aa, 0}, {ta, 0}, {p.angle, 0}};
  // aa cos A cos B + at cos A sin B + ta sin A cos B + tt sin A sin B, by the sum and the difference of A and B.
  return {{(aa - tt) / 2, (aa + tt) / 2}, {(ta + at) / 2, (ta - at) / 2}, {p.angle + q.angle, p.angle - q.angle}};
}

Waves decomposed_cosine(const TurningPair& v) {
  if (v.q[0] == v.q[1]) return turning_cosine(v);
  const Arc p(v.p[0], v.p[1]);
  const Vec3 pole = cross(p.a, p.tangent);
  float azimuth[2], elevation[2];
  for (int e = 0; e < 2; ++e) {
    const float x = dot(v.q[e], p.a), y = dot(v.q[e], p.tangent), z = dot(v.q[e], pole);
    azimuth[e] = std::copysign(angle_of(std::abs(y), x), y);
    elevation[e] = std::copysign(angle_of(std::abs(z), std::sqrt(x * x + y * y)), z);
  }
  const float turn = p.angle - std::remainder(azimuth[1] - azimuth[0], float(2 * kPi));
  const float rise = elevation[1] - elevation[0];
  // cos(elevation) cos(angle t - azimuth), by the sum and the difference of the two.
  const float sum = elevation[0] - azimuth[0], difference = elevation[0] + azimuth[0];
  return {{std::cos(sum) / 2, std::cos(difference) / 2},
          {-std::sin(sum) / 2, -std::sin(difference) / 2},
          {rise + turn, rise - turn}};
}

CombinedPair::CombinedPair(const TurningPair& v)
    : target(v.q[0] == v.q[1] ? v.q[0] : normalize_or(v.q[0] + v.q[1], v.q[0])),
      arc(turned(v.p[0], v.q[0], target), turned(v.p[1], v.q[1], target)) {}

Waves CombinedPair::cosine() const { return {{dot(arc.a, target), 0}, {dot(arc.tangent, target), 0}, {arc.angle, 0}}; }

PowerOfAngle power_of_angle(const CombinedPair& pair, float exponent) {
  const float n = std::max(exponent, 1.0f);
  const float x = dot(pair.arc.a, pair.target), y = dot(pair.arc.tangent, pair.target);
  const float highest = std::min(std::sqrt(x * x + y * y), 1.0f);
  return {std::pow(highest, n), -std::atan2(y, x), pair.arc.angle, kuijk_inner(n), kuijk_outer(n)};
}

float kuijk_power(float angle, float exponent) {
  const float n = std::max(exponent, 1.0f), a = std::abs(angle), inner = kuijk_inner(n), outer = kuijk_outer(n);
  if (a < inner) return 1 - a * a / (inner * outer);
  return a < outer ? (a - outer) * (a - outer) / (outer * (outer - inner)) : 0;
}

std::vector<float> power_recurrence(const PowerOfAngle& p, int steps) {
  const double inner = p.inner, outer = p.outer, delta = double(p.turn) / steps;
  // Of the parabolas from left to right: beyond, rim, middle, rim, beyond.
  const auto piece = [&](double a) { return a < -outer ? 0 : a < -inner ? 1 : a < inner ? 2 : a < outer ? 3 : 4; };
  const auto value = [&](int which, double a) {
    if (which == 2) return p.scale * (1 - a * a / (inner * outer));
    const double left = outer - (which == 1 ? -a : a);
    return which == 1 || which == 3 ? p.scale * left * left / (outer * (outer - inner)) : 0;
  };
  std::vector<float> out;
  double now = 0, step = 0, change = 0;
  for (int i = 0, before = -1; i <= steps; ++i) {
    const double a = p.from + delta * i;
    if (const int which = piece(a); which != before) {
      now = value(which, a), step = value(which, a + delta) - now;
      change = value(which, a + 2 * delta) - 2 * value(which, a + delta) + now;
      before = which;
    }
    out.push_back(float(now));
    now += step, step += change;
  }
  return out;
}

std::vector<float> cosine_recurrence(const Waves& w, int steps) {
  std::vector<float> out(size_t(steps) + 1);
  for (int k = 0; k < 2; ++k) {
    const double delta = double(w.turn[k]) / steps, twice = 2 * std::cos(delta);
    double now = w.cosine[k], before = w.cosine[k] * std::cos(delta) - w.sine[k] * std::sin(delta);
    for (float& value : out) {
      value += float(now);
      const double next = twice * now - before;
      before = now, now = next;
    }
  }
  return out;
}

}  // namespace aktina
