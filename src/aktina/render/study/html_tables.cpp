#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/markup.h"
#include "aktina/render/study/columns.h"
#include "aktina/render/study/html.h"

namespace aktina {
namespace {

using Group = StudyColumn::Group;

bool is_known(const Study& study, const StudyColumn& column) {
  return std::any_of(study.methods.begin(), study.methods.end(),
                     [&](const MethodStudy& m) { return !std::isnan(column.value(m)); });
}

/// Columns that are unknown for all methods are left out.
std::string table(const Study& study, Group group, const std::string& last_row) {
  std::string head = "<table class='sortable'><thead><tr><th>method</th>", body;
  for (const StudyColumn& c : study_columns())
    if (c.group == group && is_known(study, c))
      head += fmt::format("<th title='{}'>{}{}</th>", escaped(c.help), escaped(c.title),
                          c.unit == "1" ? "" : fmt::format("<br><small>{}</small>", escaped(c.unit)));
  for (const MethodStudy& m : study.methods) {
    if (!m.failure.empty()) continue;
    body +=
        fmt::format("<tr{}><th title='{}'>{}</th>", m.best ? " class='best'" : "", escaped(m.title), escaped(m.choice));
    for (const StudyColumn& c : study_columns())
      if (c.group == group && is_known(study, c))
        body += fmt::format("<td data-value='{}'>{}</td>", c.value(m), shown(c.value(m)));
    body += "</tr>";
  }
  return fmt::format("<div class='wide'>{}</tr></thead><tbody>{}</tbody>{}</table></div>", head, body, last_row);
}

std::string reference_row(const Study& study) {
  const Quality& q = study.reference_edges;
  if (std::isnan(q.edge_jump)) return "";
  return fmt::format("<p>The reference itself: edge jump {}, Mach band {}.</p>", shown(q.edge_jump),
                     shown(q.mach_band));
}

std::string growth_points(const Study& study) {
  std::string out;
  const auto one = [&](const char* title, auto member, auto size) {
    const auto& first = study.methods.front().growth.*member;
    if (first.empty()) return;
    out += fmt::format("<div class='wide'><table><thead><tr><th>frame, ms, at {}</th>", title);
    for (const GrowthPoint& p : first) out += fmt::format("<th>{}</th>", p.*size);
    out += "</tr></thead><tbody>";
    for (const MethodStudy& m : study.methods) {
      if ((m.growth.*member).empty()) continue;
      out += fmt::format("<tr><th>{}</th>", escaped(m.choice));
      for (const GrowthPoint& p : m.growth.*member)
        out += fmt::format("<td>{}{}</td>", shown(p.seconds * 1e3),
                           std::isnan(p.rmse) ? "" : fmt::format(" <small>RMSE {}</small>", shown(p.rmse)));
      out += "</tr>";
    }
    out += "</tbody></table></div>";
  };
  one("triangles", &Growth::over_triangles, &GrowthPoint::triangles);
  one("pixels", &Growth::over_pixels, &GrowthPoint::pixels);
  return out;
}

}  // namespace

std::string shown(double value) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return "∞";
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (size >= 1000) return fmt::format("{:.0f}", value);
  if (size >= 0.001) return fmt::format("{:.3g}", value);
  return fmt::format("{:.1e}", value);
}

std::string html_claims(const Study& study) {
  constexpr const char *kWords[] = {"holds", "does not hold", "not known"}, *kClasses[] = {"yes", "no", "open"};
  std::string rows;
  for (const MethodStudy& m : study.methods)
    for (const ClaimResult& c : m.claims)
      rows += fmt::format(
          "<tr><th>{}</th><td class='text'>{} <small>[{}]</small></td><td class='{}'>{}</td>"
          "<td class='text'>{}</td></tr>",
          escaped(m.choice), escaped(c.claim), escaped(c.source), kClasses[size_t(c.verdict)],
          kWords[size_t(c.verdict)], escaped(c.measured));
  if (rows.empty()) return "";
  return "<h3>Claims</h3><p>What papers say of a method, and whether it holds on this scene and machine.</p>"
         "<div class='wide'><table><thead><tr><th>method</th><th>claim</th><th>here "
         "it</th><th>measured</th></tr></thead>"
         "<tbody>" +
         rows + "</tbody></table></div>";
}

std::string html_tables(const Study& study) {
  std::string out = "<h3>Quality</h3>" + table(study, Group::quality, "") + reference_row(study);
  out += "<h3>Cost</h3>" + table(study, Group::cost, "");
  if (!study.counts_instructions)
    out += "<p>Instructions are not shown: this machine does not let programs count them, or the family is traced.</p>";
  if (study.family == "illumination")
    out += "<h3>Energy</h3><p>Of the model with the coefficients of the scene's first material.</p>" +
           table(study, Group::energy, "");
  if (study.family == "shading") out += "<h3>Operations</h3>" + table(study, Group::operations, "");
  if (!study.methods.front().growth.over_pixels.empty())
    out += "<h3>Growth</h3>" + table(study, Group::growth, "") + growth_points(study);
  return out;
}

}  // namespace aktina
