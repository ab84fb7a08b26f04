#include "aktina/radiosity/solver/direct_apart.h"

#include <algorithm>

#include "aktina/base/statistics.h"

namespace aktina {

DirectApart::DirectApart(const Scene& scene, const Sides& sides, const Visibility& visibility,
                         const RadiosityOptions& options, const MeshOptions& mesh, DirectLight direct,
                         Progress* progress, KeptDirectLight& kept)
    : sides_(sides),
      hits_(sides),
      open_(hits_.open_shares()),
      patches_(sides, mesh.coarse_size(total_area(sides.mesh())), open_, visibility),
      geometry_(sides, patches_, false),
      surfaces_(scene, geometry_, visibility),
      rays_(patches_, sides, hits_, options.seed),
      factors_(geometry_, visibility, surfaces_, ray_cast_samples(options.formfactor), options.seed, &rays_),
      interpolation_(patches_, sides, visibility) {
  const DirectSources sources(scene, sides, open_, visibility, options, mesh);
  if (direct.all.empty()) sources.shine_on(sides.all(), direct, kept, progress);
  direct_ = std::move(direct.all);
  RadiosityProblem all = sides.problem();
  for (const Rgb lamps : direct.lamps)
    for (int c = 0; c < 3; ++c) all.arriving.push_back(double(lamps[c]));
  emitted_ = all.emitted();
  sources.take_out(all.emissions);
  make_problem(all);
}

void DirectApart::make_problem(const RadiosityProblem& all) {
  problem_.bands = all.bands, problem_.weights = all.weights;
  for (size_t i = 0; i < patches_.size(); ++i) problem_.areas.push_back(patches_.area(i));
  problem_.reflectances = patches_.means(all.reflectances, 3);
  problem_.emissions = patches_.means(all.emissions, 3);
  if (!all.passing.empty()) problem_.passing = patches_.means(all.passing, 3);
  problem_.shoot_one_by_one();
  std::vector<double> arriving(direct_.size() * 3);
  for (size_t k = 0; k < arriving.size(); ++k) arriving[k] = double(direct_[k / 3][int(k % 3)]);
  problem_.arriving = patches_.means(arriving, 3);
}

double DirectApart::absorbed(const std::vector<Rgb>& irradiances) const {
  const PatchMesh& mesh = sides_.mesh();
  Sum sum;
  for (size_t s = 0; s < sides_.size(); ++s) {
    const uint32_t i = sides_.patch(s);
    const Rgb taken = Rgb(1) - mesh.reflectances[i] - mesh.transmittances[i];
    sum.add(patches_.open_area(s) * double(luminance(taken * irradiances[s])));
  }
  return sum.value();
}

DirectApart::Light DirectApart::on_sides(const RadiosityState& coarse) const {
  Light light{direct_, direct_, {}};
  std::vector<double> indirect = coarse.irradiances, from_emitters = coarse.direct;
  for (size_t k = 0; k < indirect.size(); ++k) indirect[k] -= problem_.arriving[k];
  interpolation_.add(indirect, open_, light.irradiances);
  bool others_emit = false;  // than those that were computed apart
  for (size_t k = 0; k < from_emitters.size(); ++k) {
    from_emitters[k] -= problem_.arriving[k];
    others_emit = others_emit || problem_.emissions[k] > 0;
  }
  if (others_emit) interpolation_.add(from_emitters, open_, light.direct);
  RadiosityState& a = light.account;
  a.steps = coarse.steps, a.converged = coarse.converged;
  a.emitted = emitted_;
  a.unshot_share = emitted_ > 0 ? coarse.unshot_share * problem_.emitted() / emitted_ : 0;
  a.absorbed = absorbed(light.irradiances);
  a.escaped = a.emitted - a.absorbed - a.unshot_share * a.emitted;
  return light;
}

}  // namespace aktina
