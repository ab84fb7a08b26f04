#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/markup.h"
#include "aktina/render/study/html.h"
#include "aktina/render/study/html_axes.h"

namespace aktina {
namespace {

constexpr double kLabelWidth = 126, kLabelHeight = 14;

struct Point {
  const MethodStudy* method;
  double time, error;  // ms, RMSE
  double x = 0, y = 0, label = 0;
};

/// Labels stand right of their points, each moved down below those before it that it would lie on.
void place_labels(std::vector<Point>& points) {
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
  for (size_t i = 0; i < points.size(); ++i) {
    Point& own = points[i];
    own.label = own.y;
    for (size_t tries = 0; tries <= i; ++tries)  // as often as there are labels that can be in the way
      for (size_t j = 0; j < i; ++j) {
        const bool beside = std::abs(points[j].x - own.x) > kLabelWidth;
        if (!beside && std::abs(points[j].label - own.label) < kLabelHeight) own.label = points[j].label + kLabelHeight;
      }
  }
}

std::string front(std::vector<Point> points) {
  std::erase_if(points, [](const Point& p) { return !p.method->best; });
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  std::string path;
  for (const Point& p : points) path += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  return fmt::format("<polyline class='front' points='{}'/>", path);
}

std::string mark(const Point& p) {
  const MethodStudy& m = *p.method;
  std::string out = fmt::format("<g class='{}'><title>{}: {} ms, RMSE {}</title>", m.best ? "best" : "other",
                                escaped(m.choice), shown(p.time), shown(p.error));
  if (std::abs(p.label - p.y) > 1)
    out +=
        fmt::format("<line class='lead' x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}'/>", p.x, p.y, p.x + 9, p.label);
  return out + fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='5'/><text x='{:.1f}' y='{:.1f}'>{}</text></g>", p.x, p.y,
                           p.x + 11, p.label + 4, escaped(m.choice));
}

}  // namespace

std::string html_chart(const Study& study) {
  std::vector<Point> points;
  std::vector<double> times, errors;
  bool zero = false;
  for (const MethodStudy& m : study.methods) {
    const double time = m.cost.times.empty() ? kNotMeasured : m.cost.times[0].seconds * 1e3, error = m.quality.rmse;
    if (!(time > 0) || !std::isfinite(error)) continue;
    points.push_back({&m, time, error});
    times.push_back(time);
    if (error > 0) errors.push_back(error);
    zero = zero || error == 0;
  }
  if (points.empty()) return "<p>Not measured: the study was stopped before.</p>";
  if (errors.empty()) errors.push_back(1);
  const double bottom = kChartHeight - kChartBottom;
  const ChartAxis x = axis_over(times, kChartLeft + 6, kChartWidth - kChartRight),
                  y = axis_over(errors, bottom - (zero ? 26 : 6), kChartTop);
  for (Point& p : points) p.x = x.at(p.time), p.y = p.error > 0 ? y.at(p.error) : bottom;
  place_labels(points);
  std::string out =
      fmt::format("<svg viewBox='0 0 {} {}' role='img' aria-label='error against time'>", kChartWidth, kChartHeight);
  out += html_axes(x, y, "time of a frame on one thread, ms", "RMSE") + front(points);
  if (zero)
    out += fmt::format("<text class='tick' x='{}' y='{}' text-anchor='end'>0</text>", kChartLeft - 8, bottom + 1);
  for (const Point& p : points) out += mark(p);
  return out + "</svg>";
}

}  // namespace aktina
