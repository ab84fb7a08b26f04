// Light between patches as an equation, in any number of bands: what every radiosity solver takes and gives.
//
//     B = E + rho H,     H_s = H0_s + sum_j F_sj B_j
//
// Receivers s are small elements; what shoots (j) are ranges of neighbouring receivers, of one or more each, that
// shine with the mean radiosity of their members (substructuring: M. Cohen, D. Greenberg, D. Immel, P. Brock, "An
// Efficient Radiosity Approach for Realistic Image Synthesis", IEEE CG&A 6(3), 1986).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "aktina/base/archive.h"
#include "aktina/base/progress.h"

namespace aktina {

class Checkpoint;
class ReceiverSurfaces;
struct Camera;

/// Values by receiver and band stand band by band: [receiver * bands + band].
struct RadiosityProblem {
  struct Range {
    uint32_t first = 0, count = 1;
  };

  size_t bands = 3;
  std::vector<double> weights;       // of each band in sums over bands: luminance
  std::vector<double> areas;         // by receiver, m^2
  std::vector<double> reflectances;  // rho, by receiver and band, in [0, 1)
  std::vector<double> passing;       // share that goes straight on, by receiver and band; empty: none
  std::vector<double> emissions;     // E, by receiver and band
  std::vector<double> arriving;      // H0, from lights that are no surfaces, by receiver and band; empty: none
  std::vector<Range> shooters;       // together all receivers, in order, each once

  size_t size() const { return areas.size(); }
  /// All of it, weighted: surfaces' own flux and what arrives from lights.
  double emitted() const;
  /// Each receiver shoots for itself.
  void shoot_one_by_one();
};

/// Rays that leave receivers as their diffuse light does: how solvers by random choice see form factors.
class LightRays {
 public:
  struct Ray {
    uint32_t from, number;  // the receiver, and which ray of its own well-spread sequence
  };
  struct Arrival {
    uint32_t ray, receiver;  // the index in `rays`
    float share;             // below 1 beyond what lets light through
  };
  virtual ~LightRays() = default;
  /// Appends where the rays arrive, in their order; those that meet nothing are left out. The same for the same ray
  /// every time; may be called from several threads at once.
  virtual void follow(std::span<const Ray> rays, std::vector<Arrival>& arrivals) const = 0;
};

/// Where a solver's form factors come from.
class FactorSource {
 public:
  virtual ~FactorSource() = default;
  /// factors[s] = F_sj: what fraction of the light that leaves receiver s arrives at shooter j, for all s. The same
  /// values every time.
  virtual void column(size_t shooter, std::span<double> factors) const = 0;
  /// Rays of the same factors, where the source has them; else null.
  virtual const LightRays* rays() const { return nullptr; }
  /// The surfaces that the receivers lie on, where the factors are those of a scene by rays; else null.
  virtual const ReceiverSurfaces* surfaces() const { return nullptr; }
};

struct RadiosityState {
  std::vector<double> irradiances;  // H, by receiver and band
  std::vector<double> direct;       // the part of H that comes straight from lights and emitters
  std::vector<double> unshot;       // reflected or emitted and not yet distributed
  uint64_t steps = 0;
  double unshot_share = 1;                        // flux not yet distributed over flux emitted
  double emitted = 0, absorbed = 0, escaped = 0;  // weighted flux; emitted = absorbed + escaped + unshot
  bool converged = false;

  void archive(Archive& a) {
    a(irradiances), a(direct), a(unshot), a(steps);
    a(unshot_share), a(emitted), a(absorbed), a(escaped), a(converged);
  }
  double radiosity(const RadiosityProblem& p, size_t receiver, size_t band) const {
    const size_t k = receiver * p.bands + band;
    return p.emissions[k] + p.reflectances[k] * irradiances[k];
  }
};

/// Receivers that can be split while a solver is at work, where the light on them changes fast.
class ElementSplitter {
 public:
  static constexpr uint32_t kNew = 0xffffffff;
  virtual ~ElementSplitter() = default;
  /// Splits by the irradiances of `state`. Receivers are those of problem() and factors() from then on, and what was
  /// given for the ones before is gone; shooters stay the same, of other ranges. @return  whether any was split
  virtual bool split(const RadiosityState& state) = 0;
  virtual const RadiosityProblem& problem() const = 0;
  virtual const FactorSource& factors() const = 0;
  /// By receiver: which one it was before the last split, or kNew.
  virtual std::span<const uint32_t> origins() const = 0;
  /// As FactorSource::column, of the new receivers only, in order.
  virtual void column_of_new(size_t shooter, std::span<double> factors) const = 0;
};

struct SolverControl {
  double tolerance = 1e-3;
  double target_error = 0.01;  // relative, of irradiances, where a solver draws samples
  uint64_t most_steps = 0;     // 0: no limit
  uint32_t seed = 0;
  Progress* progress = nullptr;
  Checkpoint* checkpoint = nullptr;  // keeps what is done so far; may be null
  std::function<void(const RadiosityState&)> each_step{};
  const Camera* view = nullptr;         // the picture that the light is for, where solvers use importance; may be null
  ElementSplitter* splitter = nullptr;  // for solvers that split receivers as they go; may be null
  bool stopped(uint64_t steps) const {
    return (progress && progress->cancelled()) || (most_steps > 0 && steps >= most_steps);
  }
};

/// Flux that surfaces take up at the irradiances of `state`: neither reflected nor passed on.
double absorbed_flux(const RadiosityProblem& problem, const RadiosityState& state);
/// Flux in state.unshot.
double unshot_flux(const RadiosityProblem& problem, const RadiosityState& state);

}  // namespace aktina
