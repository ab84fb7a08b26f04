#include "aktina/radiosity/solver/direct_sources.h"

#include <algorithm>

#include "aktina/radiosity/solver/direct_light.h"
#include "aktina/radiosity/solver/emitter_light.h"
#include "aktina/radiosity/solver/shots.h"

namespace aktina {
namespace {

constexpr size_t kMostEmitters = 256;  // the brightest; what the others emit goes with the indirect light
constexpr double kEmitterSize = 4;     // coarse patches: they are seen by many, so they are fewer

}  // namespace

double total_area(const PatchMesh& mesh) {
  double sum = 0;
  for (const float a : mesh.areas) sum += double(a);
  return sum;
}

DirectSources::DirectSources(const LightGroup& lights, const Sides& sides, const std::vector<float>& open,
                             const Visibility& visibility, const RadiosityOptions& options, const MeshOptions& mesh)
    : lights_(lights),
      sides_(sides),
      open_(open),
      visibility_(visibility),
      samples_(4 * ray_cast_samples(options.formfactor)),
      seed_(options.seed),
      clusters_(sides, kEmitterSize * mesh.coarse_size(total_area(sides.mesh())), open, visibility) {
  find_emitters();
}

/// The brightest emitters, as large as several coarse patches.
void DirectSources::find_emitters() {
  const std::vector<double> means = clusters_.means([&](size_t s) { return emission(s); });
  const auto exitance = [&](uint32_t i) {
    return Rgb(float(means[3 * i]), float(means[3 * i + 1]), float(means[3 * i + 2]));
  };
  std::vector<std::pair<double, uint32_t>> powers;
  for (uint32_t i = 0; i < clusters_.size(); ++i)
    if (const double power = clusters_.area(i) * double(luminance(exitance(i))); power > 0)
      powers.emplace_back(-power, i);
  std::sort(powers.begin(), powers.end());
  powers.resize(std::min(powers.size(), kMostEmitters));
  taken_.assign(sides_.size(), 0);
  for (const auto& [power, i] : powers) {
    emitters_.push_back(i), exitances_.push_back(exitance(i));
    for (const uint32_t s : clusters_.sides(i)) taken_[s] = 1;
  }
}

void DirectSources::shine_on(std::span<const uint32_t> of, DirectLight& light, KeptDirectLight& kept,
                             Progress* progress) const {
  light.lamps.resize(sides_.size(), Rgb(0)), light.all.resize(sides_.size(), Rgb(0));
  KeptDirectLight::Call& here = kept.next(of.size());
  direct_light(lights_, sides_, of, visibility_, seed_, progress, here.lamps);
  if (here.all.loop.done() == 0) here.all.values = here.lamps.values;
  if (!emitters_.empty() && !of.empty()) {
    ShotGeometry geometry(sides_, clusters_, true);
    geometry.receive_only({of.begin(), of.end()});
    add_emitter_light(geometry, visibility_, emitters_, exitances_, samples_, seed_, progress, here.all);
  }
  for (size_t i = 0; i < of.size(); ++i)
    light.lamps[of[i]] = on_open(of[i], here.lamps.values[i]), light.all[of[i]] = on_open(of[i], here.all.values[i]);
}

}  // namespace aktina
