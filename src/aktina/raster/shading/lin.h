// The highest cosine of a highlight along a span.
#pragma once

#include <optional>

#include "aktina/raster/shading/angular.h"
#include "aktina/raster/shading/euler.h"

namespace aktina {

struct SpanPeak {
  float t, value;     // where, within 0 .. 1, for vectors that are linear and made unit; and how high
  float left, right;  // cosines at the ends
};

/// None where the highest cosine is at an end.
std::optional<SpanPeak> span_peak(const CombinedPair& pair);

/// Two parabolas through peak and ends, level at the peak.
Quadratics peak_curve(const SpanPeak& peak);

}  // namespace aktina
