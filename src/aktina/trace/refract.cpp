#include "aktina/trace/refract.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

Vec3d towards_ray(Vec3d incident, Vec3d n) { return dot(incident, n) > 0 ? -n : n; }

template <class T>
T squared(T x) {
  return x * x;
}

/// Cosine of the transmitted ray; negative: total internal reflection.
template <class T>
T transmitted_cosine(T cosine, T index_ratio) {
  const T squared_sine = (1 - cosine * cosine) / (index_ratio * index_ratio);
  return squared_sine > 1 ? T(-1) : std::sqrt(1 - squared_sine);
}

}  // namespace

Vec3d reflect_direction(Vec3d incident, Vec3d n) { return incident - (2 * dot(incident, n)) * n; }

std::optional<Vec3d> refract_direction(Vec3d incident, Vec3d n, double index_ratio) {
  n = towards_ray(incident, n);
  const double cosine = -dot(incident, n), out = transmitted_cosine(cosine, index_ratio);
  if (out < 0) return std::nullopt;
  return normalize(incident / index_ratio + (cosine / index_ratio - out) * n);
}

std::optional<Vec3d> refract_direction_whitted(Vec3d incident, Vec3d n, double index_ratio) {
  n = towards_ray(incident, n);
  const Vec3d v = incident / std::abs(dot(incident, n));
  const double radicand = index_ratio * index_ratio * squared_length(v) - squared_length(v + n);
  if (!(radicand >= 0)) return std::nullopt;
  const double kf = 1 / std::sqrt(radicand);
  return normalize(kf * (n + v) - n);
}

FresnelReflectance fresnel_reflectance(double cosine, double index_ratio) {
  if (index_ratio == 1) return {0, 0};
  cosine = std::clamp(cosine, 0.0, 1.0);
  const double out = transmitted_cosine(cosine, index_ratio);
  if (out < 0) return {1, 1};
  return {squared((cosine - index_ratio * out) / (cosine + index_ratio * out)),
          squared((index_ratio * cosine - out) / (index_ratio * cosine + out))};
}

}  // namespace aktina
