#pragma once

#include "aktina/base/random.h"
#include "aktina/illumination/model.h"

namespace aktina::test {

/// Directional albedo: the integral of f n.wi over all wi, by cosine-weighted low-discrepancy points. 1, one channel
inline double albedo(const IlluminationModel& model, const Surface& s, Vec3 wo, uint32_t points) {
  double sum = 0;
  for (uint32_t i = 0; i < points; ++i) {
    const Vec2 u = sobol_owen(i, 7);
    const float r = std::sqrt(u.x), phi = float(2 * kPi) * u.y;
    const Vec3 wi(r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(1e-12f, 1 - u.x)));
    sum += double(brdf(model, s, {0, 0, 1}, wi, wo).total().g);
  }
  return sum / points * kPi;
}

inline Vec3 direction(float theta, float phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

}  // namespace aktina::test
