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
