// Stochastic Jacobi iteration: light not yet distributed leaves as rays, as many from each receiver as its share of the
// flux asks for, at quasi-random places and directions; where they arrive it is reflected, and leaves with the next
// step. In the end each receiver looks about with rays of its own, and the two answers are averaged: many rays have
// arrived at large ones, few at small ones. Cost: rays in proportion to the receivers, whatever their number; memory of
// the order of the receivers. Weakness: noise that falls slowly with the number of rays.
//
// L. Neumann, M. Feda, M. Kopp, W. Purgathofer, "A New Stochastic Radiosity Method for Highly Complex Scenes",
// Eurographics Workshop on Rendering 1994; quasi-random: A. Keller, "Quasi-Monte Carlo Radiosity", Eurographics
// Workshop on Rendering 1996; the last look: L. Neumann, W. Purgathofer, R. Tobler et al., "The Stochastic Ray Method
// for Radiosity", Eurographics Workshop on Rendering 1995.
#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"
#include "aktina/base/statistics.h"
#include "aktina/radiosity/checkpoint.h"
#include "aktina/radiosity/solver/matrix_rays.h"
#include "aktina/radiosity/solver/solver.h"

namespace aktina {
namespace {

constexpr size_t kBatch = 1 << 18;        // rays that are followed before their light is added up
constexpr size_t kGrain = 1 << 12;        // rays
constexpr size_t kGatherGrain = 8;        // receivers
constexpr size_t kBlock = 1 << 9;         // receivers between two looks whether a checkpoint is due
constexpr double kMostReflected = 0.95;   // mean reflectance by which the flux to come is foreseen
constexpr double kLeastRays = 256;        // of a step
constexpr double kRaysAtOneError = 0.07;  // rays a receiver looks about with, times the square of the target error
constexpr double kFewestRays = 64;        // for receivers however small
constexpr double kMostRays = 1 << 16;
constexpr double kShotsPerLook = 0.5;  // rays shot for each ray that looks about

class Jacobi {
 public:
  Jacobi(const RadiosityProblem& p, const LightRays& rays, const SolverControl& control)
      : p_(p), rays_(rays), control_(control), next_(p.size(), 0) {
    state.irradiances = p.arriving;
    state.irradiances.resize(p.size() * p.bands, 0);
    state.direct = state.irradiances;
    state.emitted = p.emitted();
    state.unshot.resize(p.size() * p.bands);
    for (size_t k = 0; k < state.unshot.size(); ++k)
      state.unshot[k] = p.emissions[k] + p.reflectances[k] * state.irradiances[k];
    for (const double a : p.areas) area_ += a;
    measure();
    plan();
  }

  /// Light of the surfaces' own goes first, so that what comes straight from there is known.
  void step() {
    const bool emits = state.steps == 0 && flux(p_.emissions) > 0;
    std::vector<double> sent(emits ? p_.emissions : state.unshot), received(state.unshot.size(), 0);
    shoot(sent, received);
    if (control_.progress && control_.progress->cancelled()) return;  // half a step is no step
    for (size_t k = 0; k < received.size(); ++k) {
      state.irradiances[k] += received[k];
      state.unshot[k] += p_.reflectances[k] * received[k] - sent[k];
    }
    if (emits) state.direct = state.irradiances;
    ++state.steps;
    measure();
  }

  void archive(Archive& a) { state.archive(a), a(next_), a(arrived_); }

  /// Each receiver's irradiance by rays of its own, averaged with what has been shot to it.
  void gather() {
    const size_t bands = p_.bands;
    std::vector<double> seen(state.irradiances.size()), emitted(seen.size()), mean(p_.size()), squares(p_.size());
    if (control_.progress) control_.progress->begin("gathering", "patches", p_.size());
    KeptLoop kept(control_.checkpoint, "looks", [&](Archive& a) { a(seen), a(emitted), a(mean), a(squares); });
    kept.run(p_.size(), kBlock, control_.progress, [&](size_t first, size_t last) {
      parallel_for(last - first, kGatherGrain, [&](size_t begin, size_t end) {
        Look look;
        for (size_t s = first + begin; s < first + end && !control_.stopped(0); ++s)
          look_about(uint32_t(s), look, {&seen[s * bands], bands}, {&emitted[s * bands], bands}, mean[s], squares[s]);
        if (control_.progress) control_.progress->advance(end - begin);
      });
    });
    if (control_.stopped(0)) return;
    // Weights are the reciprocals of variances, of the mean receiver: they must not depend on what was drawn for it.
    const double brightness = area_mean(mean);
    const double variance = brightness > 0 ? area_mean(squares) / (brightness * brightness) - 1 : 0;
    for (size_t s = 0; s < p_.size(); ++s) {
      const double looked = looks(s) / std::max(variance, 1e-9), shot = arrived_ * p_.areas[s] / area_;
      for (size_t b = 0; b < bands; ++b) {
        const size_t k = s * bands + b;
        const double arriving = p_.arriving.empty() ? 0 : p_.arriving[k];
        const auto average = [&](double shots, double looks) {
          return arriving + (shot * (shots - arriving) + looked * looks) / (shot + looked);
        };
        state.irradiances[k] = average(state.irradiances[k], seen[k]);
        state.direct[k] = average(state.direct[k], emitted[k]);
      }
    }
  }

  RadiosityState state;

 private:
  struct Look {
    std::vector<LightRays::Ray> rays;
    std::vector<LightRays::Arrival> arrivals;
    std::vector<double> brightness;
  };

  double flux(const std::vector<double>& values) const {
    Sum sum;
    for (size_t k = 0; k < values.size(); ++k) sum.add(p_.areas[k / p_.bands] * p_.weights[k % p_.bands] * values[k]);
    return sum.value();
  }
  void measure() { state.unshot_share = state.emitted > 0 ? flux(state.unshot) / state.emitted : 0; }

  double area_mean(const std::vector<double>& values) const {
    double sum = 0;
    for (size_t s = 0; s < p_.size(); ++s) sum += p_.areas[s] * values[s];
    return sum / area_;
  }

  /// How many rays a receiver looks about with: fewer where it is small.
  double looks(size_t s) const {
    const double share = std::min(1.0, p_.areas[s] * double(p_.size()) / area_);
    return std::clamp(std::round(most_looks_ * share), std::min(kFewestRays, most_looks_), most_looks_);
  }

  /// How much flux a ray carries, from the flux that all reflections together will ask for.
  void plan() {
    const double error = control_.target_error;
    most_looks_ = std::clamp(std::round(kRaysAtOneError / (error * error)), 16.0, kMostRays);
    double reflected = 0, weights = 0, rays = 0;
    for (size_t b = 0; b < p_.bands; ++b) weights += p_.weights[b];
    for (size_t s = 0; s < p_.size(); ++s) {
      for (size_t b = 0; b < p_.bands; ++b)
        reflected += p_.areas[s] * p_.weights[b] * p_.reflectances[s * p_.bands + b] / (area_ * weights);
      rays += kShotsPerLook * looks(s);
    }
    const double all = flux(state.unshot) / (1 - std::min(reflected, kMostReflected));
    flux_per_ray_ = std::max(all / rays, 1e-300);
    if (control_.progress) control_.progress->begin("shooting", "rays", uint64_t(rays));
  }

  void shoot(const std::vector<double>& sent, std::vector<double>& received) {
    const std::vector<double> shares = band_shares(sent);
    std::vector<double> upto(p_.size());
    double total = 0;
    for (size_t s = 0; s < p_.size(); ++s) {
      for (size_t b = 0; b < p_.bands; ++b) total += p_.areas[s] * shares[b] * sent[s * p_.bands + b];
      upto[s] = total;
    }
    if (!(total > 0)) return;
    const double count = std::max(std::round(flux(sent) / flux_per_ray_), kLeastRays);
    std::vector<LightRays::Ray> batch;
    uint64_t done = 0;
    uint32_t s = 0;
    const CheckpointPart kept(control_.checkpoint, "shots", [&](Archive& a) { a(s), a(done), a(received); });
    const double start = double(van_der_corput_owen(uint32_t(state.steps), hash32(control_.seed)));
    while (s < p_.size()) {
      const auto until = uint64_t(upto[s] / total * count + start);  // so many rays from each as is its share
      for (; done < until; ++done) batch.push_back({s, next_[s]++});
      ++s;
      if (batch.size() < kBatch && s < p_.size()) continue;
      send(batch, sent, upto, total / count, received);
      batch.clear();
      kept.save_when_due();
    }
  }

  /// All bands count alike when rays are dealt out.
  std::vector<double> band_shares(const std::vector<double>& sent) const {
    std::vector<double> shares(p_.bands, 0);
    for (size_t s = 0; s < p_.size(); ++s)
      for (size_t b = 0; b < p_.bands; ++b) shares[b] += p_.areas[s] * sent[s * p_.bands + b];
    for (double& share : shares) share = share > 0 ? 1 / share : 0;
    return shares;
  }

  void send(const std::vector<LightRays::Ray>& batch, const std::vector<double>& sent, const std::vector<double>& upto,
            double per_ray, std::vector<double>& received) {
    const size_t chunks = (batch.size() + kGrain - 1) / kGrain;
    std::vector<std::vector<LightRays::Arrival>> arrivals(chunks);
    parallel_for(chunks, 1, [&](size_t begin, size_t end) {
      for (size_t c = begin; c < end; ++c) {
        if (control_.progress && control_.progress->cancelled()) return;
        const size_t first = c * kGrain, n = std::min(kGrain, batch.size() - first);
        rays_.follow({&batch[first], n}, arrivals[c]);
        if (control_.progress) control_.progress->advance(n);
      }
    });
    for (size_t c = 0; c < chunks; ++c)  // in one order, whoever was ready first
      for (const LightRays::Arrival& a : arrivals[c]) {
        arrived_ += double(a.share);
        const size_t from = batch[c * kGrain + a.ray].from;
        const double importance = upto[from] - (from > 0 ? upto[from - 1] : 0);
        const double scale = double(a.share) * per_ray * p_.areas[from] / (importance * p_.areas[a.receiver]);
        for (size_t b = 0; b < p_.bands; ++b) received[a.receiver * p_.bands + b] += scale * sent[from * p_.bands + b];
      }
  }

  /// @param emitted  the part of `seen` that comes straight from emitters
  /// @param mean, square  of what single rays see, weighted over bands
  void look_about(uint32_t s, Look& look, std::span<double> seen, std::span<double> emitted, double& mean,
                  double& square) const {
    const auto count = uint32_t(looks(s));
    look.rays.clear(), look.arrivals.clear();
    for (uint32_t k = 0; k < count; ++k) look.rays.push_back({s, k});
    look.brightness.assign(count, 0);
    rays_.follow(look.rays, look.arrivals);
    for (const LightRays::Arrival& a : look.arrivals)
      for (size_t b = 0; b < p_.bands; ++b) {
        const double radiosity = double(a.share) * state.radiosity(p_, a.receiver, b);
        emitted[b] += double(a.share) * p_.emissions[a.receiver * p_.bands + b] / count;
        seen[b] += radiosity / count;
        look.brightness[a.ray] += p_.weights[b] * radiosity;
      }
    for (const double each : look.brightness) mean += each / count, square += each * each / count;
  }

  const RadiosityProblem& p_;
  const LightRays& rays_;
  const SolverControl& control_;
  std::vector<uint32_t> next_;  // ray of each receiver's sequence
  double area_ = 0, arrived_ = 0, flux_per_ray_ = 0, most_looks_ = 0;
};

class StochasticJacobi final : public RadiositySolver {
 public:
  RadiosityState solve(const RadiosityProblem& problem, const FactorSource& factors,
                       const SolverControl& control) const override {
    std::unique_ptr<LightRays> made;
    if (!factors.rays()) made = std::make_unique<MatrixRays>(problem, factors, control);
    Jacobi jacobi(problem, made ? *made : *factors.rays(), control);
    RadiosityState& state = jacobi.state;
    const CheckpointPart kept(control.checkpoint, "steps", [&](Archive& a) { jacobi.archive(a); });
    while (state.unshot_share > control.tolerance && !control.stopped(state.steps)) {
      jacobi.step();
      if (control.each_step) account(problem, state), control.each_step(state);
      kept.save_when_due();
    }
    state.converged = state.unshot_share <= control.tolerance;
    if (state.converged) jacobi.gather();
    account(problem, state);
    return std::move(state);
  }
  bool needs_reciprocity() const override { return true; }

 private:
  static void account(const RadiosityProblem& problem, RadiosityState& state) {
    state.absorbed = absorbed_flux(problem, state);
    state.escaped = state.emitted - state.absorbed - unshot_flux(problem, state);
  }
};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> stochastic_jacobi_radiosity = {
    {"stochastic_jacobi", "Stochastic Jacobi iteration", "neumann1995",
     "Shoots all light at once as quasi-random rays, step by step; fast for any number of patches, a little noise."},
    [](const ParamSet&) -> std::unique_ptr<RadiositySolver> { return std::make_unique<StochasticJacobi>(); }};

}  // namespace aktina
