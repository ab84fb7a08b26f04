// Each mesher from coarse to fine, against path tracing: what a patch is worth.
#include <fmt/format.h>

#include <cmath>

#include "aktina/render/report.h"
#include "aktina/render/study/runs.h"
#include "aktina/render/study/surface_truth.h"
#include "aktina/render/study/within.h"

namespace aktina {
namespace {

constexpr double kSizes[] = {4, 2, 1, 0.5, 0.25};  // of patches, over the one that makes about kPatches of the scene
constexpr double kPatches = 4000;
constexpr double kLongest = 4;  // s: finer settings are left out
constexpr double kTolerance = 1e-4;

double surface_area(const Scene& scene) {
  double sum = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[size_t(instance.mesh)];
    const Mat3 to_world(instance.to_world);
    for (const auto& t : mesh.triangles)
      sum += 0.5 * double(length(cross(to_world * (mesh.positions[t[1]] - mesh.positions[t[0]]),
                                       to_world * (mesh.positions[t[2]] - mesh.positions[t[0]]))));
  }
  return sum;
}

}  // namespace

void run_meshers(RunWork& work) {
  const Scene scene = matt_scene(work.scene);
  work.progress.begin("path tracing the reference", "places", 0);
  const SurfaceTruth truth(scene, work.options.seed, work.progress);
  const double usual = std::sqrt(surface_area(scene) / kPatches);
  work.study.error_name = "median error of the illuminance", work.study.size_name = "patches";
  work.study.remarks.push_back(fmt::format(
      "Illuminance at {} places against path tracing, whose own standard error is {:.2g} of the mean; all surfaces are "
      "taken as matt; solved by the matrix method. Places at contacts lie within a hundredth of the scene's size of "
      "another surface.",
      truth.size(), truth.noise()));
  const auto ladders = [&](const MethodStudy& m) {
    RunLadder runs;
    for (const double size : kSizes) {
      StudyRun& run = runs.emplace_back();
      run.choice = m.choice, run.parameter = "patch_size", run.value = usual * size;
      run.setting = fmt::format("patch size {:.3g} m", run.value);
    }
    return std::vector<RunLadder>{runs};
  };
  run_ladders(work, kLongest, ladders, [&](const MethodStudy&, StudyRun& run) {
    RadiosityOptions options;
    options.solver = "matrix", options.quality = "draft", options.mesher = run.choice;
    options.patch_size = run.value, options.tolerance = kTolerance, options.seed = work.options.seed;
    Stopwatch watch;
    const Solution solution =
        within(work.progress, [&](Progress& inner) { return solve_radiosity(scene, options, &inner); });
    run.seconds = watch.lap();
    const SurfaceTruth::Errors errors = truth.errors(solution);
    run.error = errors.median, run.rms_error = errors.rms, run.contact_error = errors.contact;
    run.size = double(solution.mesh.size());
  });
}

}  // namespace aktina
