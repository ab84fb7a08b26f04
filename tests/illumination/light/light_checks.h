#pragma once

#include "aktina/base/random.h"
#include "aktina/illumination/light/light.h"

namespace aktina::test {

/// Flux through a sphere of `radius` about the origin, by illuminance at low-discrepancy points of it. lm, one channel
inline double flux_through_sphere(const Light& light, float radius, uint32_t points) {
  double sum = 0;
  for (uint32_t i = 0; i < points; ++i) {
    const Vec2 u = sobol_owen(i, 1);
    const float z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0f, 1 - z * z)), phi = float(2 * kPi) * u.y;
    const Vec3 out(r * std::cos(phi), r * std::sin(phi), z);
    const LightSample s = sample(light, out * radius);
    sum += double(s.e_perp.v.g) * std::max(0.0f, dot(s.wi, -out));  // on the inside of the sphere
  }
  return sum / points * 4 * kPi * double(radius) * double(radius);
}

}  // namespace aktina::test
