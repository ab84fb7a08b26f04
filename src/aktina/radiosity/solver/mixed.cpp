// Solutions for single lights -> the light of all of them, dimmed.
#include <fmt/core.h>

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/radiosity/solve.h"
#include "aktina/radiosity/solver/reconstruct.h"

namespace aktina {
namespace {

template <class Light>
void add(std::vector<Light>& sum, const std::vector<Light>& light, float weight) {
  for (size_t i = 0; i < sum.size(); ++i) sum[i].v += light[i].v * weight;
}

template <class Light>
void clear(std::vector<Light>& light) {
  std::fill(light.begin(), light.end(), Light());
}

void check(std::span<const Solution* const> solutions, std::span<const double> weights) {
  if (solutions.empty() || weights.size() != solutions.size())
    throw Error(Code::usage, "mix", fmt::format("{} solutions and {} weights", solutions.size(), weights.size()),
                "one weight for each solution");
  for (const double w : weights)
    if (!(w >= 0 && std::isfinite(w)))
      throw Error(Code::bad_param, "weight", fmt::format("got {}", w), "accepted 0 .. inf");
  for (const Solution* s : solutions)
    if (s->scene_hash != solutions[0]->scene_hash || s->mesh.patches != solutions[0]->mesh.patches)
      throw Error(Code::usage, "mix", "solutions on different patches", "those of one run, light by light");
}

}  // namespace

Solution mixed(std::span<const Solution* const> solutions, std::span<const double> weights) {
  check(solutions, weights);
  Solution sum = *solutions[0];
  clear(sum.mesh.emissions), clear(sum.radiosities), clear(sum.irradiances), clear(sum.back_irradiances);
  clear(sum.direct_irradiances), clear(sum.back_direct_irradiances);
  sum.emitted = sum.absorbed = sum.escaped = sum.unshot = 0;
  for (size_t k = 0; k < solutions.size(); ++k) {
    const Solution& s = *solutions[k];
    const auto w = float(weights[k]);
    add(sum.mesh.emissions, s.mesh.emissions, w), add(sum.radiosities, s.radiosities, w);
    add(sum.irradiances, s.irradiances, w), add(sum.back_irradiances, s.back_irradiances, w);
    add(sum.direct_irradiances, s.direct_irradiances, w);
    add(sum.back_direct_irradiances, s.back_direct_irradiances, w);
    sum.emitted += weights[k] * s.emitted, sum.absorbed += weights[k] * s.absorbed;
    sum.escaped += weights[k] * s.escaped, sum.unshot += weights[k] * s.unshot * s.emitted;
    sum.converged = sum.converged && s.converged;
  }
  if (sum.emitted > 0) sum.unshot /= sum.emitted;
  reconstruct_vertices(sum);
  return sum;
}

}  // namespace aktina
