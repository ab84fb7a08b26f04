// Logarithmic axes of the report's charts.
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace aktina {

inline constexpr double kChartWidth = 760, kChartHeight = 420, kChartLeft = 70, kChartRight = 150, kChartTop = 16,
                        kChartBottom = 52;  // px

/// A logarithmic axis over decades that hold all values.
struct ChartAxis {
  double low, high;  // log10
  double from, to;   // px
  double at(double value) const { return from + (std::log10(value) - low) / (high - low) * (to - from); }
};
ChartAxis axis_over(const std::vector<double>& values, double from, double to);

/// Grid, ticks and names. Inline SVG.
std::string html_axes(const ChartAxis& x, const ChartAxis& y, const std::string& x_name, const std::string& y_name);

}  // namespace aktina
