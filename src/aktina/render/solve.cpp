// The radiosity job.
#include <fmt/core.h>

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
  report.complete = solution.converged || !progress.cancelled();
  if (!solution.converged && report.complete)
    report.warnings.add(fmt::format("not converged: {:.2g} of the light is not distributed yet", solution.unshot));
}

Radiosities solve(const Scene& scene, const RadiosityOptions& options, Progress& progress) {
  Radiosities result;
  result.report = begin_report(scene, options.seed);
  Report& report = result.report;
  report.settings = fmt::format("radiosity {} {} --seed {}", report.scene_file, settings(options), options.seed);
  Stopwatch watch;
  result.solution = solve_radiosity(scene, options, &progress);
  report.time("solve", watch.lap());
  add_to_report(report, result.solution, progress);
  result.solution.settings = report.settings, result.solution.scene_hash = report.scene_hash;
  return result;
}

}  // namespace aktina
