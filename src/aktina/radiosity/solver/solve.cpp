// A scene -> patches -> light on them: the stages of a radiosity solution in their order.
#include "aktina/radiosity/solve.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "aktina/base/error.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solver/adaptive_direct.h"
#include "aktina/radiosity/solver/direct_apart.h"
#include "aktina/radiosity/solver/direct_light.h"
#include "aktina/radiosity/solver/patch_elements.h"
#include "aktina/radiosity/solver/quality.h"
#include "aktina/radiosity/solver/reconstruct.h"
#include "aktina/radiosity/solver/shots.h"
#include "aktina/radiosity/solver/solver.h"
#include "aktina/scene/tessellate.h"

namespace aktina {
namespace {

std::string settings_of(const RadiosityOptions& o) {
  return fmt::format(
      "solver={} formfactor={} mesher={} quality={} patch_size={} tolerance={} target_error={} indirect_size={} "
      "most_steps={} seed={}",
      o.solver, o.formfactor, o.mesher, o.quality, o.patch_size, o.tolerance, o.target_error, o.indirect_size,
      o.most_steps, o.seed);
}

/// Values of sides as the solution has them: by patch, front and back.
template <class Value>
void copy(const Sides& sides, const Value& value, std::vector<Irradiance>& front, std::vector<Irradiance>& back) {
  front.assign(sides.mesh().size(), Irradiance()), back.assign(sides.mesh().size(), Irradiance());
  for (size_t s = 0; s < sides.size(); ++s) (sides.is_back(s) ? back : front)[sides.patch(s)].v = value(s);
}

void fill(Solution& solution, const RadiosityState& state) {
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
  control.target_error = options.target_error;
  control.most_steps = options.most_steps;
  control.seed = options.seed;
  control.progress = progress;
  return control;
}

/// All light on all patches. Solvers that do not split patches themselves begin anew on finer ones.
void solve_on_patches(PatchElements& elements, const RadiositySolver& solver, const RadiosityOptions& options,
                      SolverControl control, Solution& solution) {
  const auto take = [&](const RadiosityState& state) {
    const auto of = [](const std::vector<double>& v) {
      return [&v](size_t s) { return Rgb(float(v[3 * s]), float(v[3 * s + 1]), float(v[3 * s + 2])); };
    };
    copy(elements.sides(), of(state.irradiances), solution.irradiances, solution.back_irradiances);
    copy(elements.sides(), of(state.direct), solution.direct_irradiances, solution.back_direct_irradiances);
    fill(solution, state);
  };
  if (options.each_step)
    control.each_step = [&](const RadiosityState& state) {
      take(state);
      options.each_step({state.steps, state.unshot_share, ambient_light(elements.problem(), state), &solution});
    };
  if (elements.can_split()) control.splitter = &elements, control.checkpoint = nullptr;  // iterates change their size
  RadiosityState state;
  do state = solver.solve(elements.problem(), elements.factors(), control);
  while (state.converged && elements.split(state));
  take(state);
}

void solve_apart(const DirectApart& apart, const RadiositySolver& solver, const Sides& sides,
                 const RadiosityOptions& options, SolverControl control, Solution& solution) {
  const auto take = [&](const RadiosityState& coarse) {
    const DirectApart::Light light = apart.on_sides(coarse);
    copy(
        sides, [&](size_t s) { return light.irradiances[s]; }, solution.irradiances, solution.back_irradiances);
    copy(
        sides, [&](size_t s) { return light.direct[s]; }, solution.direct_irradiances,
        solution.back_direct_irradiances);
    fill(solution, light.account);
  };
  if (options.each_step)
    control.each_step = [&](const RadiosityState& state) {
      take(state);
      options.each_step({state.steps, solution.unshot, ambient_light(apart.problem(), state), &solution});
    };
  control.tolerance *= apart.emitted() / std::max(apart.problem().emitted(), 1e-300);
  take(solver.solve(apart.problem(), apart.factors(), control));
}

}  // namespace

Solution solve_radiosity(const Scene& scene, const RadiosityOptions& given, Progress* progress) {
  const RadiosityOptions options = resolved(given);
  const auto mesher = make_method(meshers(), "mesher", options.mesher);
  const auto solver = make_method(solvers(), "radiosity", options.solver);
  const bool apart = options.indirect_size > 0 && is_ray_cast(options.formfactor);
  const TessellatedScene tessellated(scene);
  Solution solution;
  solution.settings = settings_of(options);
  solution.scene_hash = hash(scene).text();
  solution.seed = options.seed;
  if (progress) progress->begin("meshing", "patches", 0);
  const MeshOptions mesh = mesh_options(options, apart);
  solution.mesh = mesher->mesh(*tessellated, mesh, solution.warnings);
  require_light(scene, solution.mesh);

  const Visibility visibility(*tessellated);
  const Refinement refinement = mesher->refinement();
  std::optional<Checkpoint> checkpoint;
  if (!options.checkpoint.file.empty())
    checkpoint.emplace(options.checkpoint, solution.scene_hash, solution.settings, progress);
  SolverControl control = control_of(options, progress);
  control.checkpoint = checkpoint ? &*checkpoint : nullptr;
  if (apart) {
    KeptDirectLight kept(control.checkpoint);
    DirectLight direct;
    if (refinement.depth > 0)
      direct =
          refine_by_direct_light(*tessellated, visibility, refinement, options, mesh, solution.mesh, kept, progress);
    const Sides sides(solution.mesh);
    solve_apart(DirectApart(*tessellated, sides, visibility, options, mesh, std::move(direct), progress, kept), *solver,
                sides, options, control, solution);
  } else {
    PatchElements elements(*tessellated, visibility, refinement, options, solution.mesh, progress, control.checkpoint);
    solve_on_patches(elements, *solver, options, control, solution);
  }
  reconstruct_vertices(solution);
  return solution;
}

}  // namespace aktina
