#include "aktina/radiosity/solver/direct_apart.h"

#include <algorithm>

#include "aktina/base/statistics.h"
#include "aktina/radiosity/solver/direct_light.h"
#include "aktina/radiosity/solver/emitter_light.h"

namespace aktina {
namespace {

constexpr size_t kMostEmitters = 256;  // the brightest; what the others emit goes with the indirect light
constexpr double kEmitterSize = 4;     // coarse patches: they are seen by many, so they are fewer

double total_area(const PatchMesh& mesh) {
  double sum = 0;
  for (const float a : mesh.areas) sum += double(a);
  return sum;
}

}  // namespace

DirectApart::DirectApart(const Scene& scene, const Sides& sides, const RadiosityOptions& options,
                         const MeshOptions& mesh, Progress* progress)
    : sides_(sides),
      visibility_(scene),
      hits_(sides),
      buried_(hits_.buried()),
      patches_(sides, mesh.coarse_size(total_area(sides.mesh())), buried_),
      geometry_(sides, patches_, false),
      surfaces_(scene, geometry_, visibility_),
      rays_(patches_, sides, hits_, options.seed),
      factors_(geometry_, visibility_, surfaces_, ray_cast_samples(options.formfactor), options.seed, &rays_),
      interpolation_(patches_, sides, visibility_) {
  const std::vector<double> lamps = direct_light(scene, sides, visibility_, options.seed, progress);
  direct_.assign(sides.size(), Rgb(0));
  for (size_t k = 0; k < lamps.size(); ++k) direct_[k / 3][int(k % 3)] = float(lamps[k]);
  RadiosityProblem all = sides.problem();
  all.arriving = lamps;
  emitted_ = all.emitted();
  shoot_emitters(kEmitterSize * mesh.coarse_size(total_area(sides.mesh())), options, progress, all);
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

/// The brightest emitters, as large as several coarse patches: their light is added, their emissions are taken out of
/// `all`.
void DirectApart::shoot_emitters(double size, const RadiosityOptions& options, Progress* progress,
                                 RadiosityProblem& all) {
  const CoarsePatches clusters(sides_, size, buried_);
  const std::vector<double> means = clusters.means(all.emissions, 3);
  const auto exitance = [&](uint32_t i) {
    return Rgb(float(means[3 * i]), float(means[3 * i + 1]), float(means[3 * i + 2]));
  };
  std::vector<std::pair<double, uint32_t>> powers;
  for (uint32_t i = 0; i < clusters.size(); ++i)
    if (const double power = clusters.area(i) * double(luminance(exitance(i))); power > 0)
      powers.emplace_back(-power, i);
  std::sort(powers.begin(), powers.end());
  powers.resize(std::min(powers.size(), kMostEmitters));
  std::vector<uint32_t> emitters;
  std::vector<Rgb> exitances;
  for (const auto& [power, i] : powers) {
    emitters.push_back(i), exitances.push_back(exitance(i));
    for (const uint32_t s : clusters.sides(i)) std::fill_n(&all.emissions[3 * s], 3, 0.0);
  }
  if (!emitters.empty())
    add_emitter_light(ShotGeometry(sides_, clusters, true), visibility_, emitters, exitances,
                      4 * ray_cast_samples(options.formfactor), options.seed, progress, direct_);
}

double DirectApart::absorbed(const std::vector<Rgb>& irradiances) const {
  const PatchMesh& mesh = sides_.mesh();
  Sum sum;
  for (size_t s = 0; s < sides_.size(); ++s) {
    const uint32_t i = sides_.patch(s);
    const Rgb taken = Rgb(1) - mesh.reflectances[i] - mesh.transmittances[i];
    sum.add(double(mesh.areas[i]) * double(luminance(taken * irradiances[s])));
  }
  return sum.value();
}

DirectApart::Light DirectApart::on_sides(const RadiosityState& coarse) const {
  Light light{direct_, direct_, {}};
  std::vector<double> indirect = coarse.irradiances, from_emitters = coarse.direct;
  for (size_t k = 0; k < indirect.size(); ++k) indirect[k] -= problem_.arriving[k];
  interpolation_.add(indirect, buried_, light.irradiances);
  bool others_emit = false;  // than those that were computed apart
  for (size_t k = 0; k < from_emitters.size(); ++k) {
    from_emitters[k] -= problem_.arriving[k];
    others_emit = others_emit || problem_.emissions[k] > 0;
  }
  if (others_emit) interpolation_.add(from_emitters, buried_, light.direct);
  RadiosityState& a = light.account;
  a.steps = coarse.steps, a.converged = coarse.converged;
  a.emitted = emitted_;
  a.unshot_share = emitted_ > 0 ? coarse.unshot_share * problem_.emitted() / emitted_ : 0;
  a.absorbed = absorbed(light.irradiances);
  a.escaped = a.emitted - a.absorbed - a.unshot_share * a.emitted;
  return light;
}

}  // namespace aktina
