// The cosine between two vectors that are linear along a span, by Euler's method.
#pragma once

#include <vector>

#include "aktina/raster/shading/span_light.h"

namespace aktina {

/// Slopes at both ends of cos(t) = p.q / (|p| |q|), t = 0 .. 1 along the span, where p and q are linear and of length 1
/// at the ends.
struct EulerSlopes {
  float value[2], slope[2];  // at the left end, at the right end
  explicit EulerSlopes(const TurningPair& pair);
  /// By how much the slope changes along the span: its curve and Gouraud's differ by an eighth of it at most.
  float bend() const { return slope[1] - slope[0]; }
};

/// The published recurrence, one value for each of steps + 1 samples: p += s, s += ds, where s is the slope a step. It
/// misses the value at the right end; `corrected`, the miss is spread over all steps.
/// @pre  steps >= 1
std::vector<float> euler_recurrence(const EulerSlopes& ends, int steps, bool corrected);

/// The same curve in closed form. @param steps  of the plain method, whose curve depends on them; above 0
Quadratics euler_curve(const EulerSlopes& ends);
Quadratics plain_euler_curve(const EulerSlopes& ends, float steps);

}  // namespace aktina
