// Where rays start so that they do not meet the surface that they leave.
#pragma once

#include <bit>
#include <cmath>

#include "aktina/base/vec.h"

namespace aktina {

/// A point a few hundred roundings off p along n, however large its coordinates are; near the origin, where roundings
/// are finer than those of the arithmetic that led there, 1 / 65536 m along n.
/// C. Waechter, N. Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, 2019.
/// @param n  unit geometric normal, on the side on which the ray leaves
inline Point3 offset_point(Point3 p, Vec3 n) {
  constexpr float kNearOrigin = 1.0f / 32, kStep = 1.0f / 65536, kUlps = 256;
  Point3 out;
  for (int k = 0; k < 3; ++k) {
    const auto ulps = int32_t(kUlps * n[k]);
    const float moved = std::bit_cast<float>(std::bit_cast<int32_t>(p[k]) + (p[k] < 0 ? -ulps : ulps));
    out[k] = std::abs(p[k]) < kNearOrigin ? p[k] + kStep * n[k] : moved;
  }
  return out;
}

}  // namespace aktina
