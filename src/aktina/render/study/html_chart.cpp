#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/markup.h"
#include "aktina/render/study/html.h"

namespace aktina {
namespace {

constexpr double kWidth = 760, kHeight = 420, kLeft = 70, kRight = 150, kTop = 16, kBottom = 52;
constexpr double kLabelWidth = 126, kLabelHeight = 14;

struct Point {
  const MethodStudy* method;
  double time, error;  // ms, RMSE
  double x = 0, y = 0, label = 0;
};

/// A logarithmic axis over decades that hold all values.
struct Axis {
  double low, high;  // log10
  double from, to;   // px
  double at(double value) const { return from + (std::log10(value) - low) / (high - low) * (to - from); }
};

Axis axis_over(const std::vector<double>& values, double from, double to) {
  double low = 1e300, high = 0;
  for (const double v : values) low = std::min(low, v), high = std::max(high, v);
  low = std::log10(low) - 0.08, high = std::log10(high) + 0.08;
  if (high - low < 0.5) low -= 0.25, high += 0.25;
  return {low, high, from, to};
}

std::vector<double> ticks(const Axis& axis) {
  const double range = axis.high - axis.low;
  const std::vector<double> steps = range > 2.2   ? std::vector<double>{1}
                                    : range > 0.9 ? std::vector<double>{1, 2, 5}
                                                  : std::vector<double>{1, 1.5, 2, 3, 4, 5, 6, 8};
  std::vector<double> values;
  for (double decade = std::floor(axis.low); decade <= axis.high; ++decade)
    for (const double step : steps) {
      const double value = step * std::pow(10, decade), l = std::log10(value);
      if (l >= axis.low && l <= axis.high) values.push_back(value);
    }
  return values;
}

std::string axes(const Axis& x, const Axis& y, bool zero) {
  std::string out;
  const double bottom = kHeight - kBottom, right = kWidth - kRight;
  for (const double v : ticks(x))
    out += fmt::format(
        "<line class='grid' x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}'/>"
        "<text class='tick' x='{0:.1f}' y='{3}' text-anchor='middle'>{4:g}</text>",
        x.at(v), kTop, bottom, bottom + 16, v);
  for (const double v : ticks(y))
    out += fmt::format(
        "<line class='grid' y1='{0:.1f}' y2='{0:.1f}' x1='{1}' x2='{2}'/>"
        "<text class='tick' x='{3}' y='{4:.1f}' text-anchor='end'>{5:g}</text>",
        y.at(v), kLeft, right, kLeft - 8, y.at(v) + 4, v);
  if (zero) out += fmt::format("<text class='tick' x='{}' y='{}' text-anchor='end'>0</text>", kLeft - 8, bottom + 1);
  out += fmt::format("<line class='axis' x1='{0}' x2='{1}' y1='{2}' y2='{2}'/>", kLeft, right, bottom);
  out +=
      fmt::format("<text class='name' x='{:.0f}' y='{}' text-anchor='middle'>time of a frame on one thread, ms</text>",
                  (kLeft + right) / 2, kHeight - 12);
  out += fmt::format("<text class='name' transform='translate(16 {:.0f}) rotate(-90)' text-anchor='middle'>RMSE</text>",
                     (kTop + bottom) / 2);
  return out;
}

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
  const double bottom = kHeight - kBottom;
  const Axis x = axis_over(times, kLeft + 6, kWidth - kRight), y = axis_over(errors, bottom - (zero ? 26 : 6), kTop);
  for (Point& p : points) p.x = x.at(p.time), p.y = p.error > 0 ? y.at(p.error) : bottom;
  place_labels(points);
  std::string out =
      fmt::format("<svg viewBox='0 0 {} {}' role='img' aria-label='error against time'>", kWidth, kHeight);
  out += axes(x, y, zero) + front(points);
  for (const Point& p : points) out += mark(p);
  return out + "</svg>";
}

}  // namespace aktina
