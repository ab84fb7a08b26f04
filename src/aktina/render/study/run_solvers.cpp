// Each radiosity solver from rough to fine, against path tracing.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "aktina/render/report.h"
#include "aktina/render/study/peak_memory.h"
#include "aktina/render/study/runs.h"
#include "aktina/render/study/surface_truth.h"
#include "aktina/render/study/within.h"

namespace aktina {
namespace {

struct Level {
  const char* quality;
  double tolerance, target_error;
};
constexpr Level kLevels[] = {{"draft", 0.3, 0.2},   {"draft", 0.1, 0.1},    {"draft", 0.03, 0.05},
                             {"draft", 0.01, 0.03}, {"draft", 0.001, 0.01}, {"normal", 0.001, 0.01}};
constexpr double kLongest = 4;      // s: finer settings are left out
constexpr double kBalanced = 1e-9;  // tolerance of the converged solution

std::vector<RunLadder> ladders(const MethodStudy& m) {
  RunLadder runs;
  for (const Level& level : kLevels) {
    StudyRun& run = runs.emplace_back();
    run.choice = m.choice;
    run.setting =
        fmt::format("{}, tolerance {:g}, target error {:g}", level.quality, level.tolerance, level.target_error);
    run.parameter = level.quality, run.value = level.tolerance;
  }
  return {runs};
}

RadiosityOptions options_of(const StudyRun& run, uint32_t seed) {
  RadiosityOptions options;
  options.solver = run.choice, options.seed = seed;
  for (const Level& level : kLevels)
    if (run.parameter == level.quality && run.value == level.tolerance)
      options.quality = level.quality, options.tolerance = level.tolerance, options.target_error = level.target_error;
  return options;
}

/// Root mean squared difference of the patches' illuminance over its mean, by area; unknown on other patches.
double distance(const Solution& a, const Solution& b) {
  if (a.mesh.areas != b.mesh.areas) return kNotMeasured;
  double squares = 0, sum = 0, area = 0;
  for (size_t i = 0; i < a.mesh.size(); ++i) {
    const double w = double(a.mesh.areas[i]), own = double(luminance(a.irradiances[i].v)),
                 other = double(luminance(b.irradiances[i].v));
    squares += w * (own - other) * (own - other), sum += w * other, area += w;
  }
  return sum > 0 ? std::sqrt(squares / area) / (sum / area) : kNotMeasured;
}

}  // namespace

void run_solvers(RunWork& work) {
  const Scene scene = matt_scene(work.scene);
  work.progress.begin("path tracing the reference", "places", 0);
  const SurfaceTruth truth(scene, work.options.seed, work.progress);
  RadiosityOptions balanced;
  balanced.solver = "matrix", balanced.quality = "draft", balanced.tolerance = kBalanced;
  balanced.seed = work.options.seed;
  const Solution converged =
      within(work.progress, [&](Progress& inner) { return solve_radiosity(scene, balanced, &inner); });
  work.study.error_name = "median error of the illuminance", work.study.size_name = "";
  work.study.remarks.push_back(fmt::format(
      "Illuminance at {} places against path tracing, whose own standard error is {:.2g} of the mean; all surfaces are "
      "taken as matt. Errors below what patches can show do not fall any further: what a solver has left to balance is "
      "its distance from the matrix solution of the same form factors.",
      truth.size(), truth.noise()));
  run_ladders(work, kLongest, ladders, [&](const MethodStudy&, StudyRun& run) {
    const RadiosityOptions options = options_of(run, work.options.seed);
    const PeakMemory memory;
    Stopwatch watch;
    const Solution solution =
        within(work.progress, [&](Progress& inner) { return solve_radiosity(scene, options, &inner); });
    run.seconds = watch.lap(), run.bytes = memory.bytes();
    const SurfaceTruth::Errors errors = truth.errors(solution);
    run.error = errors.median, run.rms_error = errors.rms, run.contact_error = errors.contact;
    run.off_balance = distance(solution, converged);
    run.steps = double(solution.steps), run.size = double(solution.mesh.size());
  });
}

}  // namespace aktina
