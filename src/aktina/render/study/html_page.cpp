#include <fmt/format.h>

#include "aktina/base/error.h"
#include "aktina/base/markup.h"
#include "aktina/base/version.h"
#include "aktina/render/study/html.h"
#include "aktina/render/study/output.h"

namespace aktina {
namespace {

std::string remarks(const Study& study) {
  if (study.remarks.empty()) return "";
  std::string items;
  for (const std::string& remark : study.remarks) items += fmt::format("<li>{}</li>", escaped(remark));
  return fmt::format("<h3>In plain words</h3><ul>{}</ul>", items);
}

std::string facts(const Study& s) {
  return fmt::format(
      "<p class='facts'>{} × {} px · {} triangles · {} pixels covered · reference: {} · exposure {:.4g} · seed {} · "
      "scene "
      "hash {} · {} thread{}{}</p><p class='facts'><code>aktina {}</code></p>",
      s.reference_picture.width, s.reference_picture.height, s.triangles, s.covered_pixels, escaped(s.reference),
      s.exposure, s.report.seed, escaped(s.report.scene_hash), s.report.threads, s.report.threads == 1 ? "" : "s",
      s.report.complete ? "" : " · <strong>stopped before its end</strong>", escaped(s.report.settings));
}

std::string run_section(const Study& study, size_t number) {
  const std::string facts = fmt::format(
      "<p class='facts'>{} triangles · reference: {} · seed {} · scene hash {}{}</p><p class='facts'><code>aktina {}"
      "</code></p>",
      study.triangles, escaped(study.reference), study.report.seed, escaped(study.report.scene_hash),
      study.report.complete ? "" : " · <strong>stopped before its end</strong>", escaped(study.report.settings));
  return fmt::format(
      "<section id='study{}'><h2>{}: {}</h2>{}{}<h3>Error against {}</h3><p>Each line joins a method's best runs: left "
      "is cheaper, low is nearer to the reference.</p><div class='wide'>{}</div>{}{}</section>",
      number, escaped(study.scene), escaped(study.family), facts, remarks(study),
      study.size_name.empty() ? "time" : study.size_name, html_run_chart(study), html_claims(study),
      html_run_table(study));
}

std::string section(const Study& study, size_t number) {
  if (!study.error_name.empty()) return run_section(study, number);
  return fmt::format(
      "<section id='study{}'><h2>{}: {}</h2>{}{}<h3>Error against cost</h3><p>Left is quicker, low is nearer to the "
      "reference. The line is the Pareto front: no method is both quicker and nearer than one on it.</p>"
      "<div class='wide'>{}</div>{}{}{}</section>",
      number, escaped(study.scene), escaped(study.family), facts(study), remarks(study), html_chart(study),
      html_tables(study), html_claims(study), html_pictures(study, number));
}

std::string contents(std::span<const Study> studies) {
  if (studies.size() < 2) return "";
  std::string items;
  for (size_t i = 0; i < studies.size(); ++i)
    items +=
        fmt::format("<li><a href='#study{}'>{}: {}</a></li>", i, escaped(studies[i].scene), escaped(studies[i].family));
  return fmt::format("<nav><ul>{}</ul></nav>", items);
}

}  // namespace

std::string study_html(std::span<const Study> studies) {
  std::string sections;
  for (size_t i = 0; i < studies.size(); ++i) sections += section(studies[i], i);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' content='width=device-width, "
      "initial-scale=1'><title>Aktina study</title><style>{}</style></head><body><header><h1>Which method is good "
      "enough, "
      "and what does it cost?</h1><p>Made by Aktina {}. Times are the least of several frames, the methods taken in "
      "turn; "
      "compare them with each other, not with other machines. Columns sort by a click; their names explain themselves "
      "under the pointer.</p></header>{}<main>{}</main><script>{}</script></body></html>\n",
      kStudyStyle, version(), contents(studies), sections, kStudyScript);
}

}  // namespace aktina
