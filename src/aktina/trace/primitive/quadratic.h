// Shared by the quadrics of this folder.
#pragma once

#include <cmath>

namespace aktina {

/// Real roots of a t^2 + 2 b t + c, ascending.
struct Roots {
  int count = 0;
  double t[2] = {};
};

/// Without cancellation: the larger root in magnitude first, the other from their product c / a.
inline Roots solve_quadratic(double a, double b, double c, double discriminant) {
  if (a == 0) return b == 0 ? Roots{} : Roots{1, {-c / (2 * b), 0}};
  if (!(discriminant >= 0)) return {};
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double t0 = q / a, t1 = q == 0 ? t0 : c / q;
  return t0 < t1 ? Roots{2, {t0, t1}} : Roots{2, {t1, t0}};
}

}  // namespace aktina
