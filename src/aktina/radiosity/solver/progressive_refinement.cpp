#include "aktina/radiosity/solver/progressive_refinement.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/base/statistics.h"
#include "aktina/radiosity/checkpoint.h"

namespace aktina {
namespace {

constexpr size_t kGrain = 64;  // shooters

}  // namespace

ProgressiveRefinement::ProgressiveRefinement(const RadiosityProblem& p, Shot shot)
    : p_(&p), shot_(shot), emission_left_(p.shooters.size(), 1) {
  state_.irradiances = p.arriving;
  state_.irradiances.resize(p.size() * p.bands, 0);
  state_.direct = state_.irradiances;
  state_.unshot = radiosities();
  state_.emitted = p.emitted();
  power_.resize(p.shooters.size());
  received_.resize(p.shooters.size());
  for (size_t i = 0; i < power_.size(); ++i) {
    power_[i] = flux(state_.unshot, p.shooters[i]);
    const std::vector<double> reflectance = mean(p.reflectances, p.shooters[i]);
    double area = 0;
    for (size_t s = p.shooters[i].first; s < p.shooters[i].first + p.shooters[i].count; ++s) area += p.areas[s];
    for (const double r : reflectance) reflecting_.push_back(area * r);
  }
  measure();
}

/// E + rho H, by receiver and band.
std::vector<double> ProgressiveRefinement::radiosities() const {
  std::vector<double> b(p_->size() * p_->bands);
  for (size_t k = 0; k < b.size(); ++k) b[k] = p_->emissions[k] + p_->reflectances[k] * state_.irradiances[k];
  return b;
}

double ProgressiveRefinement::flux(const std::vector<double>& values, RadiosityProblem::Range range) const {
  double sum = 0;
  for (size_t s = range.first; s < range.first + range.count; ++s)
    for (size_t b = 0; b < p_->bands; ++b) sum += p_->areas[s] * p_->weights[b] * values[s * p_->bands + b];
  return sum;
}

std::vector<double> ProgressiveRefinement::mean(const std::vector<double>& values,
                                                RadiosityProblem::Range range) const {
  std::vector<double> sums(p_->bands, 0);
  double area = 0;
  for (size_t s = range.first; s < range.first + range.count; ++s) {
    area += p_->areas[s];
    for (size_t b = 0; b < p_->bands; ++b) sums[b] += p_->areas[s] * values[s * p_->bands + b];
  }
  for (double& sum : sums) sum /= area;
  return sums;
}

/// By band: the radiosity that all light not yet distributed would have if it were spread evenly, with all its
/// reflections; 0 where shots leave it out.
std::vector<double> ProgressiveRefinement::ambient() const {
  std::vector<double> ambient(p_->bands, 0);
  if (shot_ == Shot::unshot) return ambient;
  double area = 0;
  for (const double a : p_->areas) area += a;
  for (size_t b = 0; b < p_->bands; ++b) {
    double unshot = 0, reflecting = 0;
    for (size_t s = 0; s < p_->size(); ++s) {
      unshot += p_->areas[s] * state_.unshot[s * p_->bands + b];
      reflecting += p_->areas[s] * p_->reflectances[s * p_->bands + b];
    }
    ambient[b] = unshot / (area - reflecting);
  }
  return ambient;
}

/// The shooter that has most to send, of either sign.
size_t ProgressiveRefinement::brightest(const std::vector<double>& ambient) const {
  size_t best = 0;
  double most = -1;
  for (size_t i = 0; i < power_.size(); ++i) {
    double power = power_[i];
    for (size_t b = 0; b < p_->bands && shot_ == Shot::with_ambient; ++b)
      power += p_->weights[b] * ambient[b] * reflecting_[i * p_->bands + b];
    if (std::abs(power) > most) most = std::abs(power), best = i;
  }
  return best;
}

void ProgressiveRefinement::step(const FactorSource& source) {
  const std::vector<double> around = ambient();
  const size_t i = brightest(around);
  const auto range = p_->shooters[i];
  factors_.resize(p_->size());
  source.column(i, factors_);
  std::vector<double> own(p_->bands, 0);
  if (emission_left_[i]) own = mean(p_->emissions, range);
  emission_left_[i] = 0;
  std::vector<double> all = mean(state_.unshot, range);
  const std::vector<double> reflectance = mean(p_->reflectances, range);
  for (size_t b = 0; b < p_->bands; ++b) all[b] += reflectance[b] * around[b];
  const double before = power_[i];
  for (size_t s = range.first; s < range.first + range.count; ++s)
    for (size_t b = 0; b < p_->bands; ++b)
      state_.unshot[s * p_->bands + b] = -p_->reflectances[s * p_->bands + b] * around[b];
  const double sent = before - flux(state_.unshot, range);
  parallel_for(p_->shooters.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) receive(k, all, own);
  });
  Sum received;
  for (const double r : received_) received.add(r);
  state_.escaped += sent - received.value();
  ++state_.steps;
  measure();
}

/// The members of shooter k take what they get from `all`, of which `own` comes straight from an emitter.
void ProgressiveRefinement::receive(size_t k, const std::vector<double>& all, const std::vector<double>& own) {
  const auto range = p_->shooters[k];
  double received = 0;
  for (size_t s = range.first; s < range.first + range.count; ++s) {
    const double factor = factors_[s];
    if (factor == 0) continue;
    for (size_t b = 0; b < p_->bands; ++b) {
      const size_t at = s * p_->bands + b;
      const double h = factor * all[b], kept = p_->passing.empty() ? 1 : 1 - p_->passing[at];
      state_.irradiances[at] += h;
      state_.direct[at] += factor * own[b];
      state_.unshot[at] += p_->reflectances[at] * h;
      received += p_->areas[s] * p_->weights[b] * kept * h;
    }
  }
  received_[k] = received;
  power_[k] = flux(state_.unshot, range);
}

void ProgressiveRefinement::measure() {
  Sum left;
  for (const double power : power_) left.add(std::abs(power));
  state_.unshot_share = state_.emitted > 0 ? left.value() / state_.emitted : 0;
}

void ProgressiveRefinement::run(const FactorSource& source, const SolverControl& control) {
  const CheckpointPart kept(control.checkpoint, "shots", [&](Archive& a) { archive(a); });
  while (state_.unshot_share > control.tolerance && !control.stopped(state_.steps)) {
    step(source);
    if (control.progress) control.progress->advance();
    if (control.each_step) {
      state_.absorbed = absorbed_flux(*p_, state_);
      control.each_step(state_);
    }
    kept.save_when_due();
  }
}

RadiosityState ProgressiveRefinement::finish(const SolverControl& control) {
  state_.absorbed = absorbed_flux(*p_, state_);
  state_.converged = state_.unshot_share <= control.tolerance;
  return std::move(state_);
}

bool ProgressiveRefinement::split(ElementSplitter& splitter, const SolverControl& control) {
  const size_t shooters = p_->shooters.size(), bands = p_->bands;
  std::vector<double> shot, emitted;  // by shooter and band, so far
  const std::vector<double> all = radiosities();
  for (size_t j = 0; j < shooters; ++j) {
    const std::vector<double> b = mean(all, p_->shooters[j]), left = mean(state_.unshot, p_->shooters[j]),
                              e = mean(p_->emissions, p_->shooters[j]);
    for (size_t k = 0; k < bands; ++k) shot.push_back(b[k] - left[k]), emitted.push_back(emission_left_[j] ? 0 : e[k]);
  }
  if (!splitter.split(state_)) return false;
  const std::vector<uint32_t> fresh = move_to(splitter.problem(), splitter.origins());
  factors_.resize(fresh.size());
  for (size_t j = 0; j < shooters && !control.stopped(state_.steps); ++j) {
    const std::span<const double> of_j(&shot[j * bands], bands);
    if (std::all_of(of_j.begin(), of_j.end(), [](double v) { return v == 0; })) continue;
    splitter.column_of_new(j, factors_);
    send(fresh, factors_, of_j, {&emitted[j * bands], bands});
  }
  settle(shot);
  return true;
}

/// Receivers that stay take their light along.
/// @return  those that are new
std::vector<uint32_t> ProgressiveRefinement::move_to(const RadiosityProblem& next, std::span<const uint32_t> origins) {
  const RadiosityState old = state_;
  p_ = &next;
  state_.irradiances = next.arriving;
  state_.irradiances.resize(next.size() * next.bands, 0);
  state_.direct = state_.irradiances;
  std::vector<uint32_t> fresh;
  for (uint32_t s = 0; s < next.size(); ++s) {
    if (origins[s] == ElementSplitter::kNew) {
      fresh.push_back(s);
      continue;
    }
    for (size_t b = 0; b < next.bands; ++b) {
      state_.irradiances[s * next.bands + b] = old.irradiances[origins[s] * next.bands + b];
      state_.direct[s * next.bands + b] = old.direct[origins[s] * next.bands + b];
    }
  }
  return fresh;
}

void ProgressiveRefinement::send(const std::vector<uint32_t>& to, std::span<const double> factors,
                                 std::span<const double> all, std::span<const double> own) {
  for (size_t i = 0; i < to.size(); ++i)
    for (size_t b = 0; b < p_->bands; ++b) {
      state_.irradiances[to[i] * p_->bands + b] += factors[i] * all[b];
      state_.direct[to[i] * p_->bands + b] += factors[i] * own[b];
    }
}

/// What shoots has yet to shoot what its members radiate on the average beyond what it has `shot`.
void ProgressiveRefinement::settle(const std::vector<double>& shot) {
  state_.unshot = radiosities();
  Sum left;
  for (size_t j = 0; j < p_->shooters.size(); ++j) {
    const auto range = p_->shooters[j];
    for (size_t s = range.first; s < range.first + range.count; ++s)
      for (size_t b = 0; b < p_->bands; ++b) state_.unshot[s * p_->bands + b] -= shot[j * p_->bands + b];
    power_[j] = flux(state_.unshot, range);
    left.add(power_[j]);
  }
  state_.emitted = p_->emitted();
  state_.escaped = state_.emitted - absorbed_flux(*p_, state_) - left.value();
  measure();
}

}  // namespace aktina
