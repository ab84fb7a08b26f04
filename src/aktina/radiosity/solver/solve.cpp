// A scene -> patches -> light on them: the stages of a radiosity solution in their order.
#include "aktina/radiosity/solve.h"

#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solver/direct_light.h"
#include "aktina/radiosity/solver/reconstruct.h"
#include "aktina/radiosity/solver/shots.h"
#include "aktina/radiosity/solver/solver.h"
#include "aktina/scene/tessellate.h"

namespace aktina {
namespace {

std::string settings_of(const RadiosityOptions& o) {
  return fmt::format("solver={} formfactor={} mesher={} patch_size={:g} tolerance={:g} most_steps={} seed={}", o.solver,
                     o.formfactor, o.mesher, o.patch_size, o.tolerance, o.most_steps, o.seed);
}

/// Values of sides as the solution has them: by patch, front and back.
void copy(const Sides& sides, const std::vector<double>& values, std::vector<Irradiance>& front,
          std::vector<Irradiance>& back) {
  front.assign(sides.mesh().size(), Irradiance()), back.assign(sides.mesh().size(), Irradiance());
  for (size_t s = 0; s < sides.size(); ++s)
    (sides.is_back(s) ? back : front)[sides.patch(s)].v = {float(values[3 * s]), float(values[3 * s + 1]),
                                                           float(values[3 * s + 2])};
}

void fill(Solution& solution, const Sides& sides, const RadiosityState& state) {
  copy(sides, state.irradiances, solution.irradiances, solution.back_irradiances);
  copy(sides, state.direct, solution.direct_irradiances, solution.back_direct_irradiances);
  solution.radiosities.resize(solution.mesh.size());
  for (size_t i = 0; i < solution.mesh.size(); ++i)
    solution.radiosities[i].v =
        solution.mesh.emissions[i].v + solution.mesh.reflectances[i] * solution.irradiances[i].v;
  solution.steps = state.steps;
  solution.unshot = state.unshot_share;
  solution.emitted = state.emitted, solution.absorbed = state.absorbed, solution.escaped = state.escaped;
  solution.converged = state.converged;
}

/// What has not been shot yet, spread evenly: a guess for display.
Radiosity ambient_light(const RadiosityProblem& p, const RadiosityState& state) {
  Radiosity ambient;
  double area = 0;
  for (const double a : p.areas) area += a;
  for (size_t b = 0; b < 3; ++b) {
    double unshot = 0, reflectance = 0;
    for (size_t s = 0; s < p.size(); ++s) {
      unshot += p.areas[s] * state.unshot[3 * s + b];
      reflectance += p.areas[s] * p.reflectances[3 * s + b];
    }
    ambient.v[int(b)] = float(unshot / area / (1 - reflectance / area));
  }
  return ambient;
}

void require_light(const Scene& scene, const PatchMesh& mesh) {
  const bool emits =
      std::any_of(mesh.emissions.begin(), mesh.emissions.end(), [](Radiosity e) { return !is_black(e.v); });
  if (!emits && !has_lamps(scene))
    throw Error(Code::bad_input, scene.source, "nothing shines in the scene",
                "an emissive material, a lamp or an environment; or add_default_light()");
}

SolverControl control_of(const RadiosityOptions& options, Progress* progress) {
  SolverControl control;
  control.tolerance = options.tolerance;
  control.most_steps = options.most_steps;
  control.progress = progress;
  return control;
}

}  // namespace

Solution solve_radiosity(const Scene& scene, const RadiosityOptions& options, Progress* progress) {
  const auto mesher = make_method(meshers(), "mesher", options.mesher);
  const auto solver = make_method(solvers(), "radiosity", options.solver);
  const TessellatedScene tessellated(scene);
  Solution solution;
  solution.settings = settings_of(options);
  solution.scene_hash = hash(scene).text();
  solution.seed = options.seed;
  if (progress) progress->begin("meshing", "patches", 0);
  solution.mesh = mesher->mesh(*tessellated, {options.patch_size, options.most_patches}, solution.warnings);
  require_light(scene, solution.mesh);

  const Sides sides(solution.mesh);
  const Visibility visibility(*tessellated);
  const auto factors = make_shots(options.formfactor, sides, visibility, options.seed);
  RadiosityProblem problem = sides.problem();
  problem.arriving = direct_light(*tessellated, sides, visibility, options.seed, progress);
  SolverControl control = control_of(options, progress);
  if (options.each_step)
    control.each_step = [&](const RadiosityState& state) {
      fill(solution, sides, state);
      options.each_step({state.steps, state.unshot_share, ambient_light(problem, state), &solution});
    };
  fill(solution, sides, solver->solve(problem, *factors, control));
  reconstruct_vertices(solution);
  return solution;
}

}  // namespace aktina
