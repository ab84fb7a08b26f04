#include "aktina/illumination/facets.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

/// h of two unit directions and its cosines; `valid` where all that the models divide by is positive.
struct Half {
  float n_h, v_h;
  bool valid;
};
Half half(Vec3 n, Vec3 wi, Vec3 wo) {
  const Vec3 h = normalize_or(wi + wo, n);
  const float v_h = dot(wo, h);
  return {dot(n, h), v_h, v_h > 0};
}

}  // namespace

float angle_between(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

float facet_phong(float alpha, float c1) {
  const float c = std::cos(alpha);
  return c > 0 ? std::pow(c, c1) : 0;
}

float facet_gaussian(float alpha, float c2) { return std::exp(-c2 * c2 * alpha * alpha); }

float facet_trowbridge_reitz(float alpha, float c3) {
  const float c = std::cos(alpha), s = std::sin(alpha), c3_2 = c3 * c3;
  const float d = c3_2 / std::max(c3_2 * c * c + s * s, 1e-20f);  // cos^2 (c3^2 - 1) + 1, without cancellation
  return d * d;
}

float facet_beckmann(float alpha, float m) {
  const float c = std::cos(alpha);
  if (!(c > 1e-6f)) return 0;
  const float slope = std::tan(alpha) / m, c2 = c * c;
  return std::exp(-slope * slope) / (m * m * c2 * c2);
}

FacetWidths facet_widths(float beta) {
  const double c = std::cos(double(beta)), c2 = c * c;
  return {float(-std::log(2.0) / std::log(c)), float(std::sqrt(std::log(2.0)) / double(beta)),
          float(std::sqrt((c2 - 1) / (c2 - std::sqrt(2.0))))};
}

float groove_masking(Vec3 n, Vec3 wi, Vec3 wo) {
  const Half h = half(n, wi, wo);
  if (!h.valid) return 1;
  const float factor = 2 * h.n_h / h.v_h;
  return std::clamp(std::min(factor * dot(n, wo), factor * dot(n, wi)), 0.0f, 1.0f);
}

float groove_masking_over_view(Vec3 n, Vec3 wi, Vec3 wo) {
  const Half h = half(n, wi, wo);
  const float n_v = dot(n, wo);
  if (!h.valid || !(n_v > 0)) return 0;
  const float factor = 2 * h.n_h / h.v_h;
  if (factor * n_v < 1 && n_v < dot(n, wi)) return std::max(factor, 0.0f);  // n.v cancels
  return groove_masking(n, wi, wo) / n_v;
}

float fresnel_dielectric(float cosine, float eta) {
  const float c = std::clamp(cosine, 0.0f, 1.0f), g2 = eta * eta + c * c - 1;
  if (g2 <= 0) return 1;
  const float g = std::sqrt(g2), minus = g - c, plus = g + c;
  if (plus == 0) return 1;
  const float a = minus / plus, b = (c * plus - 1) / (c * minus + 1);
  return 0.5f * a * a * (1 + b * b);
}

float facet_slope(const Surface& s) { return std::max(s.roughness * s.roughness, 1e-3f); }

}  // namespace aktina
