// The view-factor job.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "aktina/base/error.h"
#include "aktina/base/hash.h"
#include "aktina/base/parallel.h"
#include "aktina/render/view_factor_job.h"

namespace aktina {
namespace {

std::string hash_of(const ViewFactorScene& scene) {
  Hash64 hash;
  for (const auto* list : {&scene.pieces, &scene.occluders})
    for (const Polygon& polygon : *list) hash.add_values(std::span<const Point3d>(polygon.vertices));
  hash.add_values(std::span<const uint32_t>(scene.owners));
  hash.add_values(std::span<const double>(scene.transmittances));
  for (const std::string& name : scene.names) hash.add(name);
  return hash.text();
}

Report begin_report(const ViewFactorScene& scene) {
  Report report;
  report.scene_file = scene.source;
  report.scene_hash = hash_of(scene);
  report.warnings.add(scene.warnings);
  report.threads = thread_count();
  report.count("surfaces", double(scene.surfaces()));
  report.count("polygons", double(scene.pieces.size()));
  return report;
}

void add_to_report(Report& report, const ViewFactorResult& result) {
  const Certificate& c = result.certificate;
  report.count("entries", double(result.factors.factors.size()));
  report.count("least_row_sum", c.least_sum);
  report.count("most_row_sum", c.most_sum);
  report.count("largest_error", c.largest_error);
}

bool all_known(const std::vector<GrayBody>& bodies) {
  return std::all_of(bodies.begin(), bodies.end(),
                     [](const GrayBody& body) { return std::isfinite(body.temperature) || std::isfinite(body.flux); });
}

void add_gray_body(const ViewFactorScene& scene, const ViewFactorJob& job, ViewFactorResult& result) {
  result.bodies = job.bodies.empty() ? gray_bodies(scene, GrayBody{}.emissivity) : job.bodies;
  result.exchange = gray_exchange(result.factors, result.bodies);
  const bool asked = std::any_of(result.bodies.begin(), result.bodies.end(), [](const GrayBody& body) {
    return std::isfinite(body.temperature) || std::isfinite(body.flux);
  });
  if (!asked) return;
  if (!all_known(result.bodies)) {
    result.report.warnings.add("no balance of heat: surfaces have neither a temperature nor a flux");
    return;
  }
  result.balance = gray_balance(result.factors, result.bodies, job.surroundings);
  result.balanced = true;
  result.report.count("net_heat", result.balance.net, "W");
}

}  // namespace

ViewFactorResult view_factors(const ViewFactorScene& scene, const ViewFactorJob& job, Progress& progress) {
  if ((job.repair || job.gray_body) && !scene.transmittances.empty())
    throw Error(Code::unsupported, job.repair ? "repair" : "gray body", "surfaces that let light through",
                "leave them opaque: glass is, for heat");
  ViewFactorResult result;
  result.report = begin_report(scene);
  Stopwatch watch;
  result.factors = view_factors(scene, job.options, &progress);
  result.report.time("view factors", watch.lap());
  result.certificate = certify(result.factors);
  add_to_report(result.report, result);
  result.report.time("certificate", watch.lap());
  if (!result.factors.complete.empty()) {
    result.report.complete = false;
    const auto rows = std::count(result.factors.complete.begin(), result.factors.complete.end(), 1);
    result.report.warnings.add(
        fmt::format("stopped: {} of {} rows are complete; what lies between two of the others is not known", rows,
                    result.factors.size()));
    return result;
  }
  if (job.repair) {
    result.largest_repair = repair(result.factors);
    result.repaired = true;
    result.report.time("repair", watch.lap());
  }
  if (job.gray_body) {
    add_gray_body(scene, job, result);
    result.report.time("grey bodies", watch.lap());
  }
  return result;
}

std::string certificate_json(const ViewFactorResult& result) {
  const Certificate& c = result.certificate;
  const std::vector<std::string>& names = result.factors.names;
  nlohmann::ordered_json json = {
      {"closed", c.closed},
      {"closure", {{"least_row_sum", c.least_sum}, {"most_row_sum", c.most_sum}, {"rms", c.mean_closure}}},
      {"reciprocity", {{"largest_difference", c.worst_reciprocity}}},
      {"bounds", {{"least", c.least}, {"most", c.most}, {"outside", c.out_of_bounds}}},
      {"obstruction", {{"largest_excess", c.largest_excess}, {"pairs_held", c.held}}},
      {"error",
       {{"largest", c.largest_error}, {"from", names[c.largest_error_row]}, {"to", names[c.largest_error_column]}}}};
  auto& worst = json["worst_rows"] = nlohmann::ordered_json::array();
  for (const Certificate::Row& row : c.worst)
    worst.push_back({{"surface", names[row.surface]}, {"index", row.surface}, {"sum", row.sum}, {"error", row.error}});
  if (!result.factors.complete.empty()) json["complete_rows"] = result.factors.complete;
  json["repaired"] = result.repaired;
  if (result.repaired) json["largest_repair"] = result.largest_repair;
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void write_view_factors(const Path& path, const ViewFactorScene& scene, const ViewFactorResult& result) {
  ViewFactorFile file{result.factors, scene};
  if (result.exchange.size > 0) file.exchange = &result.exchange, file.bodies = &result.bodies;
  if (result.balanced) file.balance = &result.balance;
  file.certificate = certificate_json(result);
  file.metadata = provenance(result.report);
  write_view_factors(path, file);
}

}  // namespace aktina
