#include "aktina/radiosity/solver/patch_elements.h"

#include "aktina/radiosity/solver/adaptive_direct.h"
#include "aktina/radiosity/solver/direct_light.h"

namespace aktina {

PatchElements::PatchElements(const Scene& scene, const Visibility& visibility, const Refinement& refinement,
                             const RadiosityOptions& options, PatchMesh& mesh, Progress* progress,
                             Checkpoint* checkpoint)
    : scene_(scene),
      visibility_(visibility),
      refinement_(refinement),
      options_(options),
      mesh_(mesh),
      progress_(progress),
      stage_(stage()),
      lamps_(checkpoint, "light of lamps", all_lights(scene).has_lamps() ? sides().size() : 0) {
  if (refinement.depth > 0) forest_ = std::make_unique<QuadtreeForest>(scene, mesh, options.most_patches);
  shine_on(sides().all(), lamps_);
}

std::unique_ptr<PatchElements::Stage> PatchElements::stage() const {
  auto next = std::make_unique<Stage>(scene_, visibility_, mesh_);
  if (is_ray_cast(options_.formfactor))
    next->factors = std::make_unique<RayCastShots>(next->geometry, visibility_, next->surfaces,
                                                   ray_cast_samples(options_.formfactor), options_.seed);
  else
    next->factors =
        std::make_unique<RowShots>(next->sides, make_method(formfactors(), "formfactor", options_.formfactor));
  return next;
}

/// Light of lamps and the sky on some sides.
void PatchElements::shine_on(std::span<const uint32_t> sides, KeptList<Rgb>& light) {
  const LightGroup lights = all_lights(scene_);
  if (!lights.has_lamps()) return;
  direct_light(lights, stage_->sides, sides, visibility_, options_.seed, progress_, light);
  std::vector<double>& arriving = stage_->problem.arriving;
  arriving.resize(3 * stage_->sides.size(), 0);
  for (size_t i = 0; i < sides.size(); ++i)
    for (int c = 0; c < 3; ++c) arriving[3 * sides[i] + size_t(c)] = double(light.values[i][c]);
}

void PatchElements::prepare_shots_to_new() {
  if (!is_ray_cast(options_.formfactor)) return;  // rows are of all receivers anyway
  new_geometry_ = std::make_unique<ShotGeometry>(sides());
  new_geometry_->receive_only(new_);
  shots_to_new_ = std::make_unique<RayCastShots>(*new_geometry_, visibility_, stage_->surfaces,
                                                 ray_cast_samples(options_.formfactor), options_.seed);
}

bool PatchElements::split(const RadiosityState& state) {
  if (!forest_) return false;
  std::vector<Rgb> light;
  const std::vector<double>& h = state.irradiances;
  for (size_t k = 0; k < h.size(); k += 3) light.emplace_back(float(h[k]), float(h[k + 1]), float(h[k + 2]));
  const std::vector<uint32_t> patches =
      forest_->refine(steep_patches(sides(), light, refinement_.gradient * options_.target_error), refinement_.depth);
  if (patches.empty()) return false;

  const PatchMesh before = std::move(mesh_);
  mesh_ = forest_->mesh();
  const std::unique_ptr<Stage> old = std::move(stage_);
  stage_ = stage();
  origins_ = sides().origins(Sides(before), patches, kNew);
  new_.clear();
  for (uint32_t s = 0; s < origins_.size(); ++s)
    if (origins_[s] == kNew) new_.push_back(s);
  prepare_shots_to_new();
  KeptList<Rgb> lamps(nullptr, "", new_.size());
  shine_on(new_, lamps);
  std::vector<double>& arriving = stage_->problem.arriving;
  for (size_t s = 0; s < origins_.size() && !arriving.empty(); ++s)
    for (size_t c = 0; c < 3 && origins_[s] != kNew; ++c)
      arriving[3 * s + c] = old->problem.arriving[3 * origins_[s] + c];
  return true;
}

void PatchElements::column_of_new(size_t shooter, std::span<double> factors) const {
  if (shots_to_new_) return shots_to_new_->column(shooter, factors);
  std::vector<double> all(sides().size());
  stage_->factors->column(shooter, all);
  for (size_t i = 0; i < new_.size(); ++i) factors[i] = all[new_[i]];
}

}  // namespace aktina
