#include "aktina/radiosity/solver/problem.h"

#include "aktina/base/statistics.h"

namespace aktina {
namespace {

template <class Term>
double weighted_sum(const RadiosityProblem& p, const Term& term) {
  Sum sum;
  for (size_t s = 0; s < p.size(); ++s)
    for (size_t b = 0; b < p.bands; ++b) sum.add(p.areas[s] * p.weights[b] * term(s * p.bands + b));
  return sum.value();
}

double passing(const RadiosityProblem& p, size_t k) { return p.passing.empty() ? 0 : p.passing[k]; }

}  // namespace

double RadiosityProblem::emitted() const {
  return weighted_sum(*this, [&](size_t k) {
    return emissions[k] + (arriving.empty() ? 0 : arriving[k] * (1 - aktina::passing(*this, k)));
  });
}

void RadiosityProblem::shoot_one_by_one() {
  shooters.resize(size());
  for (size_t s = 0; s < size(); ++s) shooters[s] = {uint32_t(s), 1};
}

double absorbed_flux(const RadiosityProblem& p, const RadiosityState& state) {
  return weighted_sum(p, [&](size_t k) { return (1 - p.reflectances[k] - passing(p, k)) * state.irradiances[k]; });
}

double unshot_flux(const RadiosityProblem& p, const RadiosityState& state) {
  return weighted_sum(p, [&](size_t k) { return state.unshot[k]; });
}

}  // namespace aktina
