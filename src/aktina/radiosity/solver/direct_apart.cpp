#include "aktina/radiosity/solver/direct_apart.h"

#include <algorithm>
#include <utility>

#include "aktina/base/statistics.h"

namespace aktina {

DirectApart::DirectApart(const Scene& scene, std::span<const LightGroup> groups, const Sides& sides,
                         const Visibility& visibility, const RadiosityOptions& options, const MeshOptions& mesh,
                         DirectLight direct, Progress* progress, KeptDirectLight& kept)
    : sides_(sides),
      hits_(sides),
      open_(hits_.open_shares()),
      patches_(sides, mesh.coarse_size(total_area(sides.mesh())), open_, visibility),
      geometry_(sides, patches_, false),
      surfaces_(scene, geometry_, visibility),
      rays_(patches_, sides, hits_, options.seed),
      factors_(geometry_, visibility, surfaces_, ray_cast_samples(options.formfactor), options.seed, &rays_),
      interpolation_(patches_, sides, visibility) {
  problem_.bands = 3 * groups.size();
  for (size_t i = 0; i < patches_.size(); ++i) problem_.areas.push_back(patches_.area(i));
  problem_.shoot_one_by_one();
  for (const LightGroup& lights : groups) {
    const DirectSources sources(lights, sides, open_, visibility, options, mesh);
    if (direct.all.empty()) sources.shine_on(sides.all(), direct, kept, progress);
    add_group(lights, groups.size(), sources, std::exchange(direct, {}));
  }
  weigh_groups();
}

void DirectApart::add_group(const LightGroup& lights, size_t groups, const DirectSources& sources, DirectLight direct) {
  const PatchMesh& mesh = sides_.mesh();
  Sum emitted;
  bool passes = false;
  for (size_t s = 0; s < sides_.size(); ++s) {
    const uint32_t i = sides_.patch(s);
    const Rgb taken = direct.lamps[s] * (Rgb(1) - mesh.transmittances[i]);
    emitted.add(double(mesh.areas[i]) * double(luminance(lights.emission(mesh, i).v + taken)));
    passes = passes || !is_black(mesh.transmittances[i]);
  }
  const auto put = [&](const auto& value, std::vector<double>& into) {
    const std::vector<double> means = patches_.means(value);
    into.resize(means.size() * groups);
    for (size_t k = 0; k < means.size(); ++k) into[k / 3 * problem_.bands + 3 * groups_.size() + k % 3] = means[k];
  };
  put([&](size_t s) { return mesh.reflectances[sides_.patch(s)]; }, problem_.reflectances);
  if (passes) put([&](size_t s) { return mesh.transmittances[sides_.patch(s)]; }, problem_.passing);
  put([&](size_t s) { return sources.other_emission(s); }, problem_.emissions);
  put([&](size_t s) { return direct.all[s]; }, problem_.arriving);
  for (const double weight : {0.2126, 0.7152, 0.0722}) problem_.weights.push_back(weight);  // luminance()
  groups_.push_back({std::move(direct.all), emitted.value()});
}

void DirectApart::weigh_groups() {
  for (const Group& each : groups_) emitted_ += each.emitted;
  if (groups_.size() == 1) return;
  for (size_t g = 0; g < groups_.size(); ++g) {
    if (!(groups_[g].emitted > 0)) continue;
    const double share = emitted_ / (double(groups_.size()) * groups_[g].emitted);
    for (size_t c = 0; c < 3; ++c) problem_.weights[3 * g + c] *= share;
  }
}

std::vector<double> DirectApart::bands_of(const std::vector<double>& values, size_t group) const {
  std::vector<double> three;
  three.reserve(values.size() / groups_.size());
  for (size_t first = 3 * group; first < values.size(); first += problem_.bands)
    three.insert(three.end(), values.begin() + std::ptrdiff_t(first), values.begin() + std::ptrdiff_t(first + 3));
  return three;
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

/// Over what the group emits.
double DirectApart::unshot_share(const RadiosityState& coarse, size_t group) const {
  const double emitted = groups_[group].emitted;
  if (!(emitted > 0)) return 0;
  if (groups_.size() == 1) return coarse.unshot_share * problem_.emitted() / emitted;
  Sum sum;
  for (size_t i = 0; i < problem_.size(); ++i) {
    const double* of = &coarse.unshot[i * problem_.bands + 3 * group];
    sum.add(problem_.areas[i] * double(luminance(Rgb(float(of[0]), float(of[1]), float(of[2])))));
  }
  return sum.value() / emitted;
}

DirectApart::Light DirectApart::on_sides(const RadiosityState& coarse, size_t group) const {
  const Group& own = groups_[group];
  Light light{own.direct, own.direct, {}};
  const std::vector<double> arriving = bands_of(problem_.arriving, group),
                            emissions = bands_of(problem_.emissions, group);
  std::vector<double> indirect = bands_of(coarse.irradiances, group), from_emitters = bands_of(coarse.direct, group);
  for (size_t k = 0; k < indirect.size(); ++k) indirect[k] -= arriving[k];
  interpolation_.add(indirect, open_, light.irradiances);
  bool others_emit = false;  // than those that were computed apart
  for (size_t k = 0; k < from_emitters.size(); ++k) {
    from_emitters[k] -= arriving[k];
    others_emit = others_emit || emissions[k] > 0;
  }
  if (others_emit) interpolation_.add(from_emitters, open_, light.direct);
  RadiosityState& a = light.account;
  a.steps = coarse.steps, a.converged = coarse.converged;
  a.emitted = own.emitted;
  a.unshot_share = unshot_share(coarse, group);
  a.absorbed = absorbed(light.irradiances);
  a.escaped = a.emitted - a.absorbed - a.unshot_share * a.emitted;
  return light;
}

}  // namespace aktina
