// report.json and report.csv.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "aktina/base/version.h"
#include "aktina/render/study/columns.h"
#include "aktina/render/study/output.h"
#include "aktina/render/study/runs.h"

namespace aktina {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string_view word(ClaimResult::Verdict verdict) {
  return verdict == ClaimResult::Verdict::holds   ? "holds"
         : verdict == ClaimResult::Verdict::fails ? "fails"
                                                  : "unknown";
}

std::string_view word(StudyColumn::Group group) {
  switch (group) {
    case StudyColumn::Group::quality:
      return "quality";
    case StudyColumn::Group::cost:
      return "cost";
    case StudyColumn::Group::operations:
      return "operations";
    case StudyColumn::Group::growth:
      return "growth";
    case StudyColumn::Group::energy:
      return "energy";
  }
  return "";
}

Json to_json(const std::vector<GrowthPoint>& points) {
  Json list = Json::array();
  for (const GrowthPoint& p : points)
    list.push_back({{"triangles", p.triangles},
                    {"pixels", p.pixels},
                    {"frame", number(p.seconds * 1e3)},
                    {"setup", number(p.setup_seconds * 1e3)},
                    {"pixel_half", number(p.pixel_seconds * 1e3)},
                    {"rmse", number(p.rmse)}});
  return list;
}

Json to_json(const MethodStudy& m) {
  Json json = {{"method", m.choice}, {"id", m.id}, {"title", m.title}, {"cite", m.cite}};
  json["failure"] = m.failure.empty() ? Json(nullptr) : Json(m.failure);
  for (const StudyColumn& column : study_columns())
    json[std::string(word(column.group))][std::string(column.name)] = number(column.value(m));
  json["growth"]["over_triangles"] = to_json(m.growth.over_triangles);
  json["growth"]["over_pixels"] = to_json(m.growth.over_pixels);
  json["pareto"] = m.best;
  Json& runs = json["runs"] = Json::array();
  for (const StudyRun& run : m.runs) {
    Json one = {{"run", run.name()}};
    for (const RunColumn& c : run_columns()) one[std::string(c.name)] = number(run.*c.value);
    runs.push_back(std::move(one));
  }
  Json& claims = json["claims"] = Json::array();
  for (const ClaimResult& c : m.claims)
    claims.push_back({{"claim", c.claim}, {"cite", c.source}, {"verdict", word(c.verdict)}, {"measured", c.measured}});
  return json;
}

Json to_json(const Study& s) {
  Json methods = Json::array();
  for (const MethodStudy& m : s.methods) methods.push_back(to_json(m));
  return {{"scene", s.scene},
          {"family", s.family},
          {"reference", s.reference},
          {"report", Json::parse(to_json(s.report))},
          {"width", s.reference_picture.width},
          {"height", s.reference_picture.height},
          {"triangles", s.triangles},
          {"covered_pixels", s.covered_pixels},
          {"exposure", s.exposure},
          {"run_error", s.error_name},
          {"run_size", s.size_name},
          {"reference_edge_jump", number(s.reference_edges.edge_jump)},
          {"reference_mach_band", number(s.reference_edges.mach_band)},
          {"counts_instructions", s.counts_instructions},
          {"remarks", s.remarks},
          {"methods", std::move(methods)}};
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == text.npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace

std::string study_json(std::span<const Study> studies) {
  Json columns = Json::array();
  for (const StudyColumn& c : study_columns())
    columns.push_back({{"group", word(c.group)}, {"name", c.name}, {"unit", c.unit}, {"help", c.help}});
  Json list = Json::array();
  for (const Study& s : studies) list.push_back(to_json(s));
  const Json json = {{"schema_version", kStudySchema},
                     {"program", "aktina"},
                     {"version", version()},
                     {"columns", std::move(columns)},
                     {"studies", std::move(list)}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string study_csv(std::span<const Study> studies) {
  std::string text = "scene,family,method";
  for (const StudyColumn& c : study_columns()) text += fmt::format(",{}", c.name);
  text += ",pareto,failure\n";
  for (const Study& s : studies)
    for (const MethodStudy& m : s.methods) {
      text += fmt::format("{},{},{}", quoted(s.scene), s.family, quoted(m.choice));
      for (const StudyColumn& c : study_columns()) {
        const double value = c.value(m);
        text += std::isfinite(value) ? fmt::format(",{:.9g}", value) : ",";
      }
      text += fmt::format(",{},{}\n", m.best ? 1 : 0, quoted(m.failure));
    }
  return text;
}

}  // namespace aktina
