// A scene -> patches -> light on them: the stages of a radiosity solution in their order.
#include "aktina/radiosity/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "aktina/base/error.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solver/adaptive_direct.h"
#include "aktina/radiosity/solver/direct_apart.h"
#include "aktina/radiosity/solver/light_groups.h"
#include "aktina/radiosity/solver/patch_elements.h"
#include "aktina/radiosity/solver/quality.h"
#include "aktina/radiosity/solver/reconstruct.h"
#include "aktina/radiosity/solver/shots.h"
#include "aktina/radiosity/solver/solver.h"
#include "aktina/scene/tessellate.h"

namespace aktina {
namespace {

std::string view_text(const Camera& c) {
  return fmt::format("{},{},{},{},{}", fmt::join(&c.to_world[0][0], &c.to_world[0][0] + 16, ","), int(c.kind),
                     c.vertical_fov, c.half_height, c.aspect);
}

std::string settings_of(const RadiosityOptions& o) {
  return fmt::format(
      "solver={} formfactor={} mesher={} quality={} patch_size={} tolerance={} target_error={} indirect_size={} "
      "most_steps={} seed={} importance={}",
      o.solver, o.formfactor, o.mesher, o.quality, o.patch_size, o.tolerance, o.target_error, o.indirect_size,
      o.most_steps, o.seed, o.importance ? view_text(*o.importance) : "");
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
  if (!emits && !all_lights(scene).has_lamps())
    throw Error(Code::bad_input, scene.source, "nothing shines in the scene",
                "an emissive material, a lamp or an environment; or add_default_light()");
}

SolverControl control_of(const RadiosityOptions& options, Progress* progress) {
  SolverControl control;
  control.tolerance = options.tolerance;
  control.target_error = options.target_error;
  control.most_steps = options.most_steps;
  control.seed = options.seed;
  control.view = options.importance ? &*options.importance : nullptr;
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

/// Takes a group's light over from a solver's state.
void take(const DirectApart& apart, const RadiosityState& coarse, size_t group, const Sides& sides,
          Solution& solution) {
  const DirectApart::Light light = apart.on_sides(coarse, group);
  copy(
      sides, [&](size_t s) { return light.irradiances[s]; }, solution.irradiances, solution.back_irradiances);
  copy(
      sides, [&](size_t s) { return light.direct[s]; }, solution.direct_irradiances, solution.back_direct_irradiances);
  fill(solution, light.account);
}

RadiosityState solve_apart(const DirectApart& apart, const RadiositySolver& solver, SolverControl control) {
  control.tolerance *= apart.emitted() / std::max(apart.problem().emitted(), 1e-300);
  return solver.solve(apart.problem(), apart.factors(), control);
}

/// What a solution begins with, whether lights are told apart or not.
class Run {
 public:
  Run(const Scene& scene, const RadiosityOptions& given, std::string_view kind, Progress* progress)
      : options_(resolved(given)),
        mesher_(make_method(meshers(), "mesher", options_.mesher)),
        solver_(make_method(solvers(), "radiosity", options_.solver)),
        apart_(options_.indirect_size > 0 && is_ray_cast(options_.formfactor)),
        mesh_options_(mesh_options(options_, apart_)),
        scene_(scene),
        progress_(progress),
        control_(control_of(options_, progress)) {
    if (options_.importance && !solver_->uses_importance())
      throw Error(Code::unsupported, options_.solver, "takes no account of importance",
                  "hierarchical, clustering, or a wavelet solver");
    solution_.settings = settings_of(options_) + std::string(kind);
    solution_.scene_hash = hash(scene).text();
    solution_.seed = options_.seed;
    if (progress) progress->begin("meshing", "patches", 0);
    solution_.mesh = mesher_->mesh(*scene_, mesh_options_, solution_.warnings);
    require_light(scene, solution_.mesh);
    visibility_.emplace(*scene_);
    if (!options_.checkpoint.file.empty())
      checkpoint_.emplace(options_.checkpoint, solution_.scene_hash, solution_.settings, progress);
    control_.checkpoint = checkpoint_ ? &*checkpoint_ : nullptr;
  }

  Solution all_lights() {
    if (apart_)
      solve_with_direct_apart();
    else
      solve_on_patches();
    reconstruct_vertices(solution_);
    note_end(solution_);
    return std::move(solution_);
  }

  std::vector<LightSolution> each_light() {
    if (!apart_)
      throw Error(Code::unsupported, "each light",
                  "is found where direct light is computed apart: with an indirect size and form factors by rays");
    KeptDirectLight kept(control_.checkpoint);
    refine(kept);
    const Sides sides(solution_.mesh);
    const std::vector<LightGroup> groups = aktina::each_light(*scene_);
    if (groups.size() > kMostLights)
      throw Error(Code::limit, "each light", fmt::format("{} lights", groups.size()),
                  fmt::format("at most {}: give those that are dimmed together one name", kMostLights));
    const DirectApart apart(*scene_, groups, sides, *visibility_, options_, mesh_options_, {}, progress_, kept);
    const RadiosityState state = solve_apart(apart, *solver_, control_);
    std::vector<LightSolution> solutions;
    for (size_t g = 0; g < groups.size(); ++g) {
      LightSolution& each = solutions.emplace_back(LightSolution{groups[g].name, solution_});
      for (size_t i = 0; i < solution_.mesh.size(); ++i)
        each.solution.mesh.emissions[i] = groups[g].emission(solution_.mesh, i);
      take(apart, state, g, sides, each.solution);
      reconstruct_vertices(each.solution);
      note_end(each.solution);
    }
    return solutions;
  }

 private:
  /// Whatever a solver finds, what it was given may have been cut short.
  void note_end(Solution& solution) const {
    if (progress_ && progress_->cancelled()) solution.converged = false;
  }

  static constexpr size_t kMostLights = 256;

  DirectLight refine(KeptDirectLight& kept) {
    const Refinement refinement = mesher_->refinement();
    if (refinement.depth == 0) return {};
    return refine_by_direct_light(*scene_, *visibility_, refinement, options_, mesh_options_, solution_.mesh, kept,
                                  progress_);
  }

  void solve_with_direct_apart() {
    KeptDirectLight kept(control_.checkpoint);
    DirectLight direct = refine(kept);
    const Sides sides(solution_.mesh);
    const LightGroup all[] = {aktina::all_lights(*scene_)};
    const DirectApart apart(*scene_, all, sides, *visibility_, options_, mesh_options_, std::move(direct), progress_,
                            kept);
    if (options_.each_step)
      control_.each_step = [&](const RadiosityState& state) {
        take(apart, state, 0, sides, solution_);
        options_.each_step({state.steps, solution_.unshot, ambient_light(apart.problem(), state), &solution_});
      };
    take(apart, solve_apart(apart, *solver_, control_), 0, sides, solution_);
  }

  void solve_on_patches() {
    PatchElements elements(*scene_, *visibility_, mesher_->refinement(), options_, solution_.mesh, progress_,
                           control_.checkpoint);
    aktina::solve_on_patches(elements, *solver_, options_, control_, solution_);
  }

  RadiosityOptions options_;
  std::unique_ptr<Mesher> mesher_;
  std::unique_ptr<RadiositySolver> solver_;
  bool apart_;
  MeshOptions mesh_options_;
  TessellatedScene scene_;
  Progress* progress_;
  SolverControl control_;
  Solution solution_;
  std::optional<Visibility> visibility_;
  std::optional<Checkpoint> checkpoint_;
};

}  // namespace

Solution solve_radiosity(const Scene& scene, const RadiosityOptions& options, Progress* progress) {
  return Run(scene, options, "", progress).all_lights();
}

std::vector<LightSolution> solve_each_light(const Scene& scene, const RadiosityOptions& options, Progress* progress) {
  return Run(scene, options, " each light", progress).each_light();
}

}  // namespace aktina
