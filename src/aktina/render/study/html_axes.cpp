#include "aktina/render/study/html_axes.h"

#include <fmt/format.h>

#include <algorithm>

namespace aktina {
namespace {

std::vector<double> ticks(const ChartAxis& axis) {
  const double range = axis.high - axis.low;
  const std::vector<double> steps = range > 2.2   ? std::vector<double>{1}
                                    : range > 0.9 ? std::vector<double>{1, 2, 5}
                                                  : std::vector<double>{1, 1.5, 2, 3, 4, 5, 6, 8};
  std::vector<double> values;
  for (int decade = int(std::floor(axis.low)); decade <= int(std::floor(axis.high)); ++decade)
    for (const double step : steps) {
      const double value = step * std::pow(10, decade), l = std::log10(value);
      if (l >= axis.low && l <= axis.high) values.push_back(value);
    }
  return values;
}

}  // namespace

ChartAxis axis_over(const std::vector<double>& values, double from, double to) {
  double low = 1e300, high = 0;
  for (const double v : values) low = std::min(low, v), high = std::max(high, v);
  low = std::log10(low) - 0.08, high = std::log10(high) + 0.08;
  if (high - low < 0.5) low -= 0.25, high += 0.25;
  return {low, high, from, to};
}

std::string html_axes(const ChartAxis& x, const ChartAxis& y, const std::string& x_name, const std::string& y_name) {
  std::string out;
  const double bottom = kChartHeight - kChartBottom, right = kChartWidth - kChartRight;
  for (const double v : ticks(x))
    out += fmt::format(
        "<line class='grid' x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}'/>"
        "<text class='tick' x='{0:.1f}' y='{3}' text-anchor='middle'>{4:g}</text>",
        x.at(v), kChartTop, bottom, bottom + 16, v);
  for (const double v : ticks(y))
    out += fmt::format(
        "<line class='grid' y1='{0:.1f}' y2='{0:.1f}' x1='{1}' x2='{2}'/>"
        "<text class='tick' x='{3}' y='{4:.1f}' text-anchor='end'>{5:g}</text>",
        y.at(v), kChartLeft, right, kChartLeft - 8, y.at(v) + 4, v);
  out += fmt::format("<line class='axis' x1='{0}' x2='{1}' y1='{2}' y2='{2}'/>", kChartLeft, right, bottom);
  out += fmt::format("<text class='name' x='{:.0f}' y='{}' text-anchor='middle'>{}</text>", (kChartLeft + right) / 2,
                     kChartHeight - 12, x_name);
  return out + fmt::format(
                   "<text class='name' transform='translate(16 {:.0f}) rotate(-90)' text-anchor='middle'>{}"
                   "</text>",
                   (kChartTop + bottom) / 2, y_name);
}

}  // namespace aktina
