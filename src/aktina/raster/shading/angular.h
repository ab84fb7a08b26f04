// Angles between vectors that turn uniformly on great circles.
#pragma once

#include <vector>

#include "aktina/raster/shading/span_light.h"

namespace aktina {

/// The great circle from unit vector a to unit vector b: cos(angle t) a + sin(angle t) tangent at t = 0 .. 1. Where
/// they are opposite, one of the many.
struct Arc {
  Vec3 a, tangent;  // unit, at right angles
  float angle;      // rad, 0 .. pi
  Arc(Vec3 a, Vec3 b);
  Vec3 at(float t) const;
};

/// Unit vector a share t of the way along the arc from a to b.
Vec3 slerp(Vec3 a, Vec3 b, float t);

/// Points of an arc at t = start + i step, i = 0 .. count - 1; arrays aligned to 64 bytes and padded.
void fill_arc(const Arc& arc, float start, float step, size_t count, float* const (&out)[3]);
/// The published recurrence of the same, at t = i / steps: n[i + 1] = 2 cos(delta) n[i] - n[i - 1]. @pre  steps >= 1
std::vector<Vec3> arc_recurrence(const Arc& arc, int steps);

/// The cosine between p and q, both turning uniformly: exact.
Waves turning_cosine(const TurningPair& pair);
/// Approximation by decomposition: azimuth and elevation of q, seen from the circle of p, change linearly.
Waves decomposed_cosine(const TurningPair& pair);

/// A vector that turns on a circle, against one that stands still.
struct CombinedPair {
  Vec3 target;
  Arc arc;
  /// The turning of q is given to p: exact at the ends, and where q does not turn.
  explicit CombinedPair(const TurningPair& pair);
  Waves cosine() const;
};

/// Kuijk's parabolas for cos^n of an angle that grows linearly. @pre  n >= 1
PowerOfAngle power_of_angle(const CombinedPair& pair, float exponent);
/// The power itself: f = 1 - a^2 / (A B) for |a| < A, (|a| - B)^2 / (B (B - A)) for A < |a| < B, 0 beyond.
float kuijk_power(float angle, float exponent);

/// The published recurrence of the power at t = i / steps: two additions a sample; a parabola begins with its value and
/// its first difference where the angle passes from one to the next. @pre  steps >= 1
std::vector<float> power_recurrence(const PowerOfAngle& power, int steps);

/// The published recurrence of a cosine: c[i + 1] = 2 cos(delta) c[i] - c[i - 1], one for each wave, at samples
/// t = i / steps. @pre  steps >= 1
std::vector<float> cosine_recurrence(const Waves& waves, int steps);

}  // namespace aktina
