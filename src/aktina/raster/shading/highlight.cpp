#include "aktina/raster/shading/highlight.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"

namespace aktina {
namespace {

constexpr float kRounding = 1e-6f;  // of cosines and chords of unit vectors in float

/// A cap of the unit sphere that holds the given directions and all between them: |d - axis| <= chord.
struct Cap {
  Vec3 axis;
  float chord;
};

Cap cap_towards(Vec3 at, bool distant, std::span<const Point3> corners) {
  if (distant) return {at, 0};
  Vec3 d[3], sum(0);
  for (size_t i = 0; i < corners.size(); ++i) sum += d[i] = normalize_or(at - corners[i], Vec3(0));
  Cap cap{normalize_or(sum, Vec3(0)), 0};
  for (size_t i = 0; i < corners.size(); ++i) cap.chord = std::max(cap.chord, length(d[i] - cap.axis));
  return cap;
}

/// tan^2 of the angle beyond which exp(-tan^2 / m^2) / cos^4 is less than `share`. It falls from tan^2 = 2 m^2 - 1 on.
float beckmann_reach(float m, float share) {
  const float m2 = m * m, wanted = std::log(share);
  const auto logarithm = [&](float t2) { return 2 * std::log1p(t2) - t2 / m2; };
  float low = std::max(2 * m2 - 1, 0.0f), high = std::max(1.0f, 2 * low);
  while (logarithm(high) > wanted) high *= 2;
  for (int i = 0; i < 40; ++i) {
    const float middle = 0.5f * (low + high);
    (logarithm(middle) > wanted ? low : high) = middle;
  }
  return high;
}

/// The least cosine where a distribution of facets is `share`, in (0, 1), of what it is along the normal.
float facets_cosine_at(FacetDistribution distribution, float width, float share) {
  switch (distribution) {
    case FacetDistribution::phong:
      return std::pow(share, 1 / width);
    case FacetDistribution::gaussian: {
      const float angle = std::sqrt(-std::log(share)) / width;
      return angle < 1.5f ? std::cos(angle) : 0;
    }
    case FacetDistribution::trowbridge_reitz: {  // c3^2 / (1 - (1 - c3^2) cos^2) is the root of the share
      const float c2 = width * width, cosine2 = (1 - c2 / std::sqrt(share)) / std::max(1 - c2, 1e-6f);
      return std::sqrt(std::clamp(cosine2, 0.0f, 1.0f));
    }
    default:
      return 1 / std::sqrt(1 + beckmann_reach(width, share));
  }
}

}  // namespace

float HighlightCurve::cosine_at(float share) const {
  if (power == Power::none || share > 1) return 2;
  if (share <= 0) return 0;
  if (power == Power::facets) return share < 1 ? facets_cosine_at(distribution, width, share) : 1;
  if (!(exponent > 0)) return 0;
  if (power == Power::exact) return std::pow(share, 1 / exponent);
  return std::min(share * exponent / (1 - share + share * exponent), 1.0f);  // S(t) = t / (n - n t + t)
}

HighlightCurve highlight_curve(const Illuminator& light, std::string_view method) {
  HighlightCurve curve;
  curve.exponent = std::max(light.surface().exponent, 0.0f);
  const IlluminationModel& model = light.model();
  if (const auto* phong = std::get_if<Phong>(&model)) {
    curve.power = HighlightCurve::Power::exact, curve.varies = phong->fresnel;
  } else if (std::holds_alternative<BlinnPhong>(model)) {
    curve.power = HighlightCurve::Power::exact, curve.half = true;
  } else if (const auto* schlick = std::get_if<Schlick>(&model)) {
    curve.power = HighlightCurve::Power::schlick, curve.half = schlick->half;
  } else if (const auto* sparrow = std::get_if<TorranceSparrow>(&model)) {
    curve.power = HighlightCurve::Power::facets, curve.half = curve.varies = true;
    curve.distribution = sparrow->distribution, curve.width = sparrow->width(light.surface());
  } else if (const auto* cook = std::get_if<CookTorrance>(&model)) {
    curve.power = HighlightCurve::Power::facets, curve.half = curve.varies = true;
    curve.distribution = FacetDistribution::beckmann;
    curve.width = cook->slope > 0 ? cook->slope : facet_slope(light.surface());
  } else if (!(std::holds_alternative<Constant>(model) || std::holds_alternative<Ambient>(model) ||
               std::holds_alternative<Lambert>(model) || std::holds_alternative<OrenNayar>(model))) {
    throw Error(Code::unsupported, "shading." + std::string(method),
                "the illumination model's highlight is not a function of one cosine",
                "with phong, blinn_phong, schlick, torrance_sparrow, cook_torrance, or a model without highlights");
  }
  return curve;
}

HighlightCurve sole_highlight_curve(const Illuminator& light, std::string_view method) {
  const HighlightCurve curve = highlight_curve(light, method);
  if (curve.varies)
    throw Error(Code::unsupported, "shading." + std::string(method),
                "the illumination model's highlight is not a function of one cosine",
                "with phong, blinn_phong, schlick, or a model without highlights");
  return curve;
}

EdgePeak edge_peak(Vec3 n0, Vec3 n1, Vec3 h) {
  const float a = dot(n0, h), b = dot(n1, h), c = dot(n0, n1);
  const float up = b - a * c, down = a - b * c;  // slopes towards the other end, from either
  if (!(up > 0 && down > 0)) return a >= b ? EdgePeak{a, 0} : EdgePeak{b, 1};
  const float t = up / (up + down);
  const float squared = 1 - 2 * t * (1 - t) * (1 - c);  // |(1 - t) n0 + t n1|^2
  if (!(squared > 1e-12f)) return {1, t};               // opposite normals: any direction lies between them
  return {std::min(((1 - t) * a + t * b) / std::sqrt(squared), 1.0f), t};
}

float highlight_peak(const Vec3 (&n)[3], Vec3 h) {
  float peak = -1;
  for (int edge = 0; edge < 3; ++edge) peak = std::max(peak, edge_peak(n[edge], n[(edge + 1) % 3], h).cosine);
  // h = sum k_i n_i with all k_i >= 0: by Cramer's rule, each times the determinant.
  const float determinant = dot(n[0], cross(n[1], n[2]));
  bool within = std::abs(determinant) > 1e-7f;
  for (int i = 0; i < 3; ++i) within = within && dot(h, cross(n[(i + 1) % 3], n[(i + 2) % 3])) * determinant >= 0;
  return within ? 1 : peak;
}

HighlightCone highlight_cone(const HighlightCurve& curve, float least, const Lamp& lamp, const Viewer& viewer,
                             std::span<const Point3> corners) {
  constexpr float kAll = -1, kNone = 2;
  constexpr float kWidest = 1.3f;  // below sqrt(2): caps beyond a half sphere do not hold what lies between
  if (least > 1) return {Vec3(0), kNone};
  if (lamp.shape != LampShape::point) return {Vec3(0), kAll};  // its light has many directions
  const Cap to_lamp = cap_towards(lamp.place, lamp.distant, corners);
  const Cap to_eye = cap_towards(viewer.at, viewer.distant, corners);
  if (std::max(to_lamp.chord, to_eye.chord) > kWidest) return {Vec3(0), kAll};
  const Vec3 sum = to_lamp.axis + to_eye.axis;
  const float slack = to_lamp.chord + to_eye.chord + kRounding, size = length(sum);  // |l + v - sum| <= slack
  if (!(size - slack > 1e-3f)) return {Vec3(0), kAll};
  const float half_cosine = (size - slack) / 2;  // of the angle between h and l, at least
  // Phong: r.v = 2 (n.l)(n.v) - l.v <= 1 - 2 cos^2(l, h) sin^2(n, h).
  const float squared_sine = curve.half ? 1 - least * least : (1 - least) / (2 * half_cosine * half_cosine);
  if (squared_sine >= 1) return {Vec3(0), kAll};
  const float sine = std::sqrt(std::max(squared_sine, 0.0f)), cosine = std::sqrt(1 - sine * sine);
  const float spread = slack / size;  // sine of the angle between h and the axis, at most
  return {sum / size, cosine * std::sqrt(1 - spread * spread) - sine * spread - kRounding};
}

bool may_shine(const HighlightCurve& curve, float least, const Lamp& lamp, const Viewer& viewer,
               const Point3 (&position)[3], const Vec3 (&normal)[3]) {
  if (lamp.shape != LampShape::point) return least <= 1;
  bool lit = false;  // n.l is a sum, with weights above 0, of what it is between each normal and each corner's l
  for (const Point3 p : position)
    for (const Vec3 n : normal) lit = lit || dot(n, lamp.distant ? lamp.place : lamp.place - p) > 0;
  if (!lit) return false;
  const HighlightCone cone = highlight_cone(curve, least, lamp, viewer, position);
  return cone.cosine <= -1 || highlight_peak(normal, cone.axis) >= cone.cosine;
}

}  // namespace aktina
