// Progressive refinement: again and again the shooter with the most light not yet distributed sends it to all
// receivers. Cost: one column of form factors a step, memory of the order of the receivers; a useful picture after few
// steps. Weakness: the last per cent takes as long as the matrix method; columns are computed again when a shooter's
// turn comes again.
//
// M. Cohen, S. Chen, J. Wallace, D. Greenberg, "A Progressive Refinement Approach to Fast Radiosity Image Generation",
// SIGGRAPH 1988.
#include <algorithm>

#include "aktina/base/parallel.h"
#include "aktina/base/statistics.h"
#include "aktina/radiosity/checkpoint.h"
#include "aktina/radiosity/solver/solver.h"

namespace aktina {
namespace {

constexpr size_t kGrain = 64;  // shooters

class Refinement {
 public:
  explicit Refinement(const RadiosityProblem& p) : p_(p), emission_left_(p.shooters.size(), 1) {
    state.irradiances = p.arriving;
    state.irradiances.resize(p.size() * p.bands, 0);
    state.direct = state.irradiances;
    state.unshot.resize(p.size() * p.bands);
    for (size_t k = 0; k < state.unshot.size(); ++k)
      state.unshot[k] = p.emissions[k] + p.reflectances[k] * state.irradiances[k];
    state.emitted = p.emitted();
    power_.resize(p.shooters.size());
    received_.resize(p.shooters.size());
    factors_.resize(p.size());
    for (size_t i = 0; i < power_.size(); ++i) power_[i] = flux(state.unshot, p.shooters[i]);
    measure();
  }

  void step(const FactorSource& source) {
    const size_t i = size_t(std::max_element(power_.begin(), power_.end()) - power_.begin());
    source.column(i, factors_);
    const std::vector<double> all = mean(state.unshot, p_.shooters[i]);
    std::vector<double> own(p_.bands, 0);
    if (emission_left_[i]) own = mean(p_.emissions, p_.shooters[i]);
    emission_left_[i] = 0;
    const double sent = power_[i];
    clear(p_.shooters[i]);
    parallel_for(p_.shooters.size(), kGrain, [&](size_t begin, size_t end) {
      for (size_t k = begin; k < end; ++k) receive(k, all, own);
    });
    Sum received;
    for (const double r : received_) received.add(r);
    state.escaped += sent - received.value();
    ++state.steps;
    measure();
  }

  void archive(Archive& a) { state.archive(a), a(emission_left_), a(power_); }

  RadiosityState state;

 private:
  double flux(const std::vector<double>& values, RadiosityProblem::Range range) const {
    double sum = 0;
    for (size_t s = range.first; s < range.first + range.count; ++s)
      for (size_t b = 0; b < p_.bands; ++b) sum += p_.areas[s] * p_.weights[b] * values[s * p_.bands + b];
    return sum;
  }

  std::vector<double> mean(const std::vector<double>& values, RadiosityProblem::Range range) const {
    std::vector<double> sums(p_.bands, 0);
    double area = 0;
    for (size_t s = range.first; s < range.first + range.count; ++s) {
      area += p_.areas[s];
      for (size_t b = 0; b < p_.bands; ++b) sums[b] += p_.areas[s] * values[s * p_.bands + b];
    }
    for (double& sum : sums) sum /= area;
    return sums;
  }

  void clear(RadiosityProblem::Range range) {
    std::fill_n(state.unshot.begin() + std::ptrdiff_t(range.first * p_.bands), range.count * p_.bands, 0.0);
  }

  /// The members of shooter k take what they get from `all`, of which `own` comes straight from an emitter.
  void receive(size_t k, const std::vector<double>& all, const std::vector<double>& own) {
    const auto range = p_.shooters[k];
    double received = 0;
    for (size_t s = range.first; s < range.first + range.count; ++s) {
      const double factor = factors_[s];
      if (factor == 0) continue;
      for (size_t b = 0; b < p_.bands; ++b) {
        const size_t at = s * p_.bands + b;
        const double h = factor * all[b], kept = p_.passing.empty() ? 1 : 1 - p_.passing[at];
        state.irradiances[at] += h;
        state.direct[at] += factor * own[b];
        state.unshot[at] += p_.reflectances[at] * h;
        received += p_.areas[s] * p_.weights[b] * kept * h;
      }
    }
    received_[k] = received;
    power_[k] = flux(state.unshot, range);
  }

  void measure() {
    Sum left;
    for (const double power : power_) left.add(power);
    state.unshot_share = state.emitted > 0 ? left.value() / state.emitted : 0;
  }

  const RadiosityProblem& p_;
  std::vector<uint8_t> emission_left_;
  std::vector<double> power_, received_, factors_;
};

class ProgressiveSolver final : public RadiositySolver {
 public:
  RadiosityState solve(const RadiosityProblem& problem, const FactorSource& factors,
                       const SolverControl& control) const override {
    Refinement refinement(problem);
    RadiosityState& state = refinement.state;
    const CheckpointPart kept(control.checkpoint, "shots", [&](Archive& a) { refinement.archive(a); });
    if (control.progress) control.progress->begin("solving", "shots", 0);
    while (state.unshot_share > control.tolerance && !control.stopped(state.steps)) {
      refinement.step(factors);
      if (control.progress) control.progress->advance();
      if (control.each_step) {
        state.absorbed = absorbed_flux(problem, state);
        control.each_step(state);
      }
      kept.save_when_due();
    }
    state.absorbed = absorbed_flux(problem, state);
    state.converged = state.unshot_share <= control.tolerance;
    return std::move(state);
  }
};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> progressive_radiosity = {
    {"progressive", "Progressive refinement", "cohen1988",
     "Shoots the brightest light not yet distributed first; a useful picture after few steps, little memory."},
    [](const ParamSet&) -> std::unique_ptr<RadiositySolver> { return std::make_unique<ProgressiveSolver>(); }};

}  // namespace aktina
