#pragma once

#include "aktina/illumination/light/light.h"

namespace aktina::test {

/// Irradiance of a plane by a lamp with an area: the integral of L cos cos' / d^2 over points of it, one channel.
/// @param point  of (u, v) in [0, 1]^2, evenly over the area; n need not have the whole lamp above its horizon
template <class Point>
double irradiance_by_points(Point point, double area, Vec3 front, Point3 x, Vec3 n, bool signed_sum = false) {
  constexpr int kSide = 200;
  double sum = 0;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const Vec3d d = Vec3d(point((i + 0.5) / kSide, (j + 0.5) / kSide)) - Vec3d(x);
      const double d2 = dot(d, d), c = dot(d, Vec3d(n)), b = -dot(d, Vec3d(front));
      if (b > 0 && (c > 0 || signed_sum)) sum += c * b / (d2 * d2);
    }
  return sum * area / (kSide * kSide);
}

}  // namespace aktina::test
