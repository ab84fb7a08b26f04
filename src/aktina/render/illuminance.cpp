#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "aktina/base/error.h"
#include "aktina/import/text.h"
#include "aktina/render/illuminance_job.h"
#include "aktina/render/job_report.h"

namespace aktina {
namespace {

void add_statistics(IlluminanceResult& result, const MeasuringField& field) {
  double lumens = 0, area = 0;
  result.minimum = HUGE_VAL;
  for (size_t i = 0; i < field.points.size(); ++i) {
    const double e = result.measurement.lux[i];
    if (!std::isfinite(e)) continue;
    lumens += e * field.areas[i], area += field.areas[i];
    result.minimum = std::min(result.minimum, e), result.maximum = std::max(result.maximum, e);
    ++result.points;
  }
  if (result.points == 0)
    throw Error(Code::bad_param, field.name, "all of its points lie inside of closed bodies", "move it");
  result.average = lumens / area;
}

}  // namespace

IlluminanceResult illuminance(const Scene& scene, const MeasuringField& field, const MeasureOptions& options,
                              Progress& progress) {
  IlluminanceResult result;
  Report& report = result.report = begin_report(scene, options.seed);
  report.settings = fmt::format("illuminance {} {} --method {} --target-error {} --seed {}", report.scene_file,
                                field.name, options.integrator, options.target_error, options.seed);
  Stopwatch watch;
  result.measurement = measure_illuminance(scene, field.points, field.normals, options, &progress);
  report.time("measure", watch.lap());
  report.complete = !progress.cancelled();
  add_statistics(result, field);
  report.count("points", double(result.points));
  report.count("samples", result.measurement.samples, "1/point");
  report.count("relative_error", result.measurement.error);
  if (result.measurement.inside > 0)
    report.warnings.add("points inside of closed bodies were left out", result.measurement.inside);
  return result;
}

std::string illuminance_json(const MeasuringField& field, const IlluminanceResult& r) {
  nlohmann::ordered_json json = {{"field", field.name},
                                 {"points", r.points},
                                 {"average_lx", r.average},
                                 {"minimum_lx", r.minimum},
                                 {"maximum_lx", r.maximum},
                                 {"uniformity", r.uniformity()},
                                 {"diversity", r.diversity()},
                                 {"relative_error", r.measurement.error},
                                 {"samples", r.measurement.samples}};
  if (field.is_grid()) json["columns"] = field.columns, json["rows"] = field.rows;
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

MeasuringField read_points(const Path& path) {
  const std::string text = read_text_file(path), where = display(path);
  MeasuringField field;
  field.name = path.filename().string();
  Lines lines(text);
  std::string_view line;
  bool head = true;
  while (lines.next(line)) {
    if (trimmed(line).empty() || line[0] == '#') continue;
    const std::vector<std::string> words = csv_fields(line);
    const std::string at = place(where, lines.number());
    float v[6] = {0, 0, 0, 0, 1, 0};
    const bool first = std::exchange(head, false);
    if (first && !parse_number(words[0], v[0])) continue;
    if (words.size() != 3 && words.size() != 6)
      throw Error(Code::bad_input, at, fmt::format("has {} fields", words.size()), "x,y,z or x,y,z and a normal");
    for (size_t k = 0; k < words.size(); ++k)
      if (!parse_number(words[k], v[k]) || !std::isfinite(v[k]))
        throw Error(Code::bad_input, at, fmt::format("'{}' is no number", words[k]));
    const Vec3 normal = normalize_or(Vec3(v[3], v[4], v[5]), Vec3(0));
    if (normal == Vec3(0)) throw Error(Code::bad_input, at, "its normal has no length");
    if (field.points.size() >= kMostMeasuringPoints)
      throw Error(Code::limit, at, fmt::format("more than {} points", kMostMeasuringPoints));
    field.points.push_back({v[0], v[1], v[2]});
    field.normals.push_back(normal);
    field.areas.push_back(1);
  }
  if (field.points.empty()) throw Error(Code::bad_input, where, "has no points");
  return field;
}

}  // namespace aktina
