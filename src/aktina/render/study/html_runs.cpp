// A study by runs as HTML: each method's errors as a line, all methods on one chart; the runs as a table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/markup.h"
#include "aktina/render/study/html.h"
#include "aktina/render/study/html_axes.h"
#include "aktina/render/study/runs.h"

namespace aktina {
namespace {

constexpr const char* kMarks[] = {"circle", "square", "triangle", "diamond"};

/// Lines that can be told apart by colour and mark.
std::string mark(size_t number, double x, double y) {
  const char* kind = kMarks[number / 6 % 4];
  const std::string style = fmt::format("class='dot c{}'", number % 6);
  if (kind == kMarks[0]) return fmt::format("<circle {} cx='{:.1f}' cy='{:.1f}' r='4'/>", style, x, y);
  if (kind == kMarks[1])
    return fmt::format("<rect {} x='{:.1f}' y='{:.1f}' width='7' height='7'/>", style, x - 3.5, y - 3.5);
  const double up = kind == kMarks[2] ? 3 : 5;
  return fmt::format("<polygon {} points='{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}'/>", style, x, y - 5,
                     x + 5, y + (up - 3) / 2 - (up == 3 ? -3 : 1), x, y + up, x - 5,
                     y + (up - 3) / 2 - (up == 3 ? -3 : 1));
}

struct Line {
  const MethodStudy* method;
  std::vector<const StudyRun*> runs;
  double label;  // px
};

/// Names stand right of the chart, in the order of their lines' ends, none on another.
void place_labels(std::vector<Line>& lines, const ChartAxis& y) {
  for (Line& line : lines) line.label = y.at(line.runs.back()->error);
  std::sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.label < b.label; });
  for (size_t i = 1; i < lines.size(); ++i) lines[i].label = std::max(lines[i].label, lines[i - 1].label + 15);
  const double over = lines.empty() ? 0 : lines.back().label - (kChartHeight - 8);
  if (over > 0)
    for (Line& line : lines) line.label -= over;
}

std::string drawn(const Study& study, const Line& line, const ChartAxis& x, const ChartAxis& y, double StudyRun::*at) {
  const auto number = size_t(line.method - study.methods.data());
  std::string path, marks;
  for (const StudyRun* run : line.runs) {
    const double px = x.at(run->*at), py = y.at(run->error);
    path += fmt::format("{:.1f},{:.1f} ", px, py);
    marks += fmt::format("<g><title>{}: {} {}, error {}</title>{}</g>", escaped(run->setting), shown(run->*at),
                         at == &StudyRun::seconds ? "s" : "", shown(run->error), mark(number, px, py));
  }
  const double right = kChartWidth - kChartRight;
  return fmt::format(
      "<g><polyline class='line c{0}' points='{1}'/>{2}<line class='lead' x1='{3:.1f}' y1='{4:.1f}' x2='{5}' "
      "y2='{6:.1f}'/>{7}<text x='{8}' y='{9:.1f}'>{10}</text></g>",
      number % 6, path, marks, x.at(line.runs.back()->*at), y.at(line.runs.back()->error), right + 8, line.label,
      mark(number, right + 14, line.label), right + 23, line.label + 4, escaped(line.method->choice));
}

bool is_known(const Study& study, const RunColumn& column) {
  for (const MethodStudy& m : study.methods)
    for (const StudyRun& run : m.runs)
      if (!std::isnan(run.*column.value)) return true;
  return false;
}

}  // namespace

std::string html_run_chart(const Study& study) {
  const bool by_size = !study.size_name.empty();
  double StudyRun::*const at = by_size ? &StudyRun::size : &StudyRun::seconds;
  std::vector<Line> lines;
  std::vector<double> xs, ys;
  for (const MethodStudy& m : study.methods) {
    Line line{&m, best_runs(m, at), 0};
    std::erase_if(line.runs, [](const StudyRun* run) { return !(run->error > 0); });
    for (const StudyRun* run : line.runs) xs.push_back(run->*at), ys.push_back(run->error);
    if (!line.runs.empty()) lines.push_back(line);
  }
  if (lines.empty()) return "<p>Not measured: the study was stopped before.</p>";
  const double bottom = kChartHeight - kChartBottom;
  const ChartAxis x = axis_over(xs, kChartLeft + 6, kChartWidth - kChartRight),
                  y = axis_over(ys, bottom - 6, kChartTop);
  place_labels(lines, y);
  std::string out =
      fmt::format("<svg viewBox='0 0 {} {}' role='img' aria-label='error of each method'>", kChartWidth, kChartHeight);
  out += html_axes(x, y, by_size ? study.size_name : "time on one thread, s", study.error_name);
  for (const Line& line : lines) out += drawn(study, line, x, y, at);
  return out + "</svg>";
}

std::string html_run_table(const Study& study) {
  std::string head = "<table class='sortable'><thead><tr><th>run</th>", body;
  for (const RunColumn& c : run_columns())
    if (is_known(study, c))
      head += fmt::format("<th title='{}'>{}{}</th>", escaped(c.help), escaped(c.title),
                          c.unit == "1" ? "" : fmt::format("<br><small>{}</small>", escaped(c.unit)));
  for (const MethodStudy& m : study.methods)
    for (const StudyRun& run : m.runs) {
      body += fmt::format("<tr><th>{}</th>", escaped(run.name()));
      for (const RunColumn& c : run_columns())
        if (is_known(study, c)) body += fmt::format("<td data-value='{}'>{}</td>", run.*c.value, shown(run.*c.value));
      body += "</tr>";
    }
  return fmt::format("<h3>Runs</h3><div class='wide'>{}</tr></thead><tbody>{}</tbody></table></div>", head, body);
}

}  // namespace aktina
