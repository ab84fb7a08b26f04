#include "aktina/raster/shading/highlight_track.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

struct Interval {
  double low, high;
};
constexpr Interval kNothing = {1, 0};

/// Where a s^2 + 2 b s + c >= 0 and axis + along s >= 0, on [0, 1].
Interval within_cone(double a, double b, double c, double axis, double along) {
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return a < 0 ? kNothing : Interval{0, 1};
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));  // no cancellation
  const double root0 = q / a, root1 = q != 0 ? c / q : 0;
  const double low = std::min(root0, root1), high = std::max(root0, root1);
  Interval inside{std::max(low, 0.0), std::min(high, 1.0)};
  if (a > 0) inside = along > 0 ? Interval{std::max(high, 0.0), 1} : Interval{0, std::min(low, 1.0)};
  const double middle = (inside.low + inside.high) / 2;
  return axis + along * middle >= 0 ? inside : kNothing;  // else the cone's mirror image
}

}  // namespace

HighlightTrack highlight_track(const HighlightCone& cone, Vec3 first, Vec3 last, int count) {
  if (cone.cosine <= 0) return {0, count};
  if (cone.cosine > 1) return {0, 0};
  const Vec3d h(cone.axis), n(first), d = Vec3d(last) - n;
  const double k2 = double(cone.cosine) * double(cone.cosine), nh = dot(n, h), dh = dot(d, h);
  double a = dh * dh - k2 * dot(d, d);
  if (a == 0) a = -1e-300;  // a root at infinity
  const Interval s = within_cone(a, nh * dh - k2 * dot(n, d), nh * nh - k2 * dot(n, n), nh, dh);
  if (s.low > s.high) return {0, 0};
  constexpr double kSlack = 1e-3;  // px
  const double steps = count - 1;
  const int begin = int(std::ceil(s.low * steps - kSlack)), end = int(std::floor(s.high * steps + kSlack)) + 1;
  return begin < end ? HighlightTrack{begin, end} : HighlightTrack{0, 0};
}

}  // namespace aktina
