// The radiosity job.
#include <fmt/core.h>

#include "aktina/base/error.h"
#include "aktina/export/export.h"
#include "aktina/radiosity/error_estimate.h"
#include "aktina/render/job_report.h"

namespace aktina {

void add_to_report(Report& report, const Solution& solution, const Progress& progress) {
  report.warnings.add(solution.warnings);
  report.count("patches", double(solution.mesh.size()));
  report.count("vertices", double(solution.mesh.positions.size()));
  report.count("steps", double(solution.steps));
  report.count("unshot", solution.unshot);
  report.count("emitted", solution.emitted, "lm");
  report.count("absorbed", solution.absorbed, "lm");
  report.count("escaped", solution.escaped, "lm");
  report.count("estimated_error", relative_error(solution));
  report.complete = !progress.cancelled();
  if (!solution.converged && report.complete)
    report.warnings.add(fmt::format("not converged: {:.2g} of the light is not distributed yet", solution.unshot));
}

namespace {

constexpr std::string_view kEachLight = " --each-light";

Report begin(const Scene& scene, const RadiosityOptions& options) {
  Report report = begin_report(scene, options.seed);
  report.settings = fmt::format("radiosity {} {} --seed {}", report.scene_file, settings(options), options.seed);
  return report;
}

void finish(Radiosities& result, const Progress& progress) {
  add_to_report(result.report, result.solution, progress);
  result.solution.settings = result.report.settings, result.solution.scene_hash = result.report.scene_hash;
}

}  // namespace

Radiosities solve(const Scene& scene, const RadiosityOptions& options, Progress& progress) {
  Radiosities result{{}, begin(scene, options)};
  Stopwatch watch;
  result.solution = solve_radiosity(scene, options, &progress);
  result.report.time("solve", watch.lap());
  finish(result, progress);
  return result;
}

std::vector<LightRadiosities> solve_lights(const Scene& scene, const RadiosityOptions& options, Progress& progress) {
  const Report report = begin(scene, options);
  Stopwatch watch;
  std::vector<LightSolution> lights = solve_each_light(scene, options, &progress);
  const double seconds = watch.lap();
  std::vector<LightRadiosities> results;
  for (LightSolution& each : lights) {
    Radiosities result{std::move(each.solution), report};
    result.report.settings += kEachLight;
    result.report.time("solve", seconds);
    finish(result, progress);
    results.push_back({std::move(each.name), std::move(result)});
  }
  return results;
}

Radiosities mix(std::span<const DimmedLight> lights) {
  std::vector<const Solution*> solutions;
  std::vector<double> factors;
  for (const DimmedLight& each : lights) solutions.push_back(&each.result->solution), factors.push_back(each.factor);
  Radiosities sum{mixed(solutions, factors), lights[0].result->report};
  Report& report = sum.report;
  report.counts.clear();
  if (report.settings.ends_with(kEachLight)) report.settings.erase(report.settings.size() - kEachLight.size());
  for (const DimmedLight& each : lights)
    if (each.factor != 1) report.settings += fmt::format(" --dim '{}={}'", each.light, each.factor);
  finish(sum, Progress());
  return sum;
}

void write_radiosities(const Path& path, const Scene& scene, const Radiosities& radiosities) {
  const Metadata metadata = provenance(radiosities.report);
  const std::string extension = lower_extension(path);
  if (extension == "aktina")
    save_solution(path, radiosities.solution);
  else if (extension == "vtu")
    write_vtu(path, radiosities.solution, metadata);
  else if (extension == "csv")
    write_patches_csv(path, scene, radiosities.solution, metadata);
  else if (extension == "glb" || extension == "gltf")
    write_lit_gltf(path, scene, radiosities.solution, {.metadata = metadata});
  else
    throw Error(Code::usage, display(path), "cannot tell the format from the name",
                "one of .aktina, .vtu, .csv, .glb, .gltf");
}

}  // namespace aktina
