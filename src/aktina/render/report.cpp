#include "aktina/render/report.h"

#include <chrono>
#include <nlohmann/json.hpp>

#include "aktina/base/version.h"

namespace aktina {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

Stopwatch::Stopwatch() : last_(now()) {}

double Stopwatch::lap() {
  const double time = now(), seconds = time - last_;
  last_ = time;
  return seconds;
}

std::string to_json(const Report& report) {
  nlohmann::ordered_json json = {{"program", "aktina"}, {"version", version()}};
  if (!report.settings.empty()) json.update({{"settings", report.settings}, {"seed", report.seed}});
  if (!report.scene_hash.empty()) json["scene"] = {{"file", report.scene_file}, {"hash", report.scene_hash}};
  if (report.threads > 0) json["threads"] = report.threads;
  json["complete"] = report.complete;
  auto& timings = json["timings"] = nlohmann::ordered_json::object();
  for (const Report::Timing& timing : report.timings) timings[timing.stage] = timing.seconds;
  auto& counts = json["counts"] = nlohmann::ordered_json::object();
  for (const Report::Count& count : report.counts) counts[count.name] = {{"value", count.value}, {"unit", count.unit}};
  auto& warnings = json["warnings"] = nlohmann::ordered_json::array();
  for (const Warnings::Item& item : report.warnings.items())
    warnings.push_back({{"text", item.text}, {"count", item.count}});
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::vector<std::pair<std::string, std::string>> provenance(const Report& report) {
  return {{"Software", "Aktina " + std::string(version())},
          {"Settings", report.settings},
          {"Seed", std::to_string(report.seed)},
          {"Scene", report.scene_file},
          {"SceneHash", report.scene_hash}};
}

}  // namespace aktina
