// Progressive refinement, step by step; the receivers may be others from some step on.
#pragma once

#include "aktina/radiosity/solver/solver.h"

namespace aktina {

class ProgressiveRefinement {
 public:
  /// What a shooter sends: its light that is not yet distributed; with it what it will come to reflect of all others'
  /// light, by the ambient estimate, and owes from then on.
  enum class Shot { unshot, with_ambient };

  /// `problem` must outlive this, or until split().
  explicit ProgressiveRefinement(const RadiosityProblem& problem, Shot shot = Shot::unshot);

  /// Shoots the most light that is not yet distributed.
  void step(const FactorSource& source);
  /// Steps until `control` says that it is enough.
  void run(const FactorSource& source, const SolverControl& control);
  /// Asks for receivers to be split, and sends the new ones what the others have received so far; what they reflect
  /// otherwise than those before them is light to be shot, of either sign.
  /// @return  whether there are new ones
  bool split(ElementSplitter& splitter, const SolverControl& control);
  const RadiosityState& state() const { return state_; }
  void archive(Archive& a) { state_.archive(a), a(emission_left_), a(power_); }
  /// The state, with its accounts in order.
  RadiosityState finish(const SolverControl& control);

 private:
  double flux(const std::vector<double>& values, RadiosityProblem::Range range) const;
  std::vector<double> mean(const std::vector<double>& values, RadiosityProblem::Range range) const;
  std::vector<double> radiosities() const;
  void receive(size_t shooter, const std::vector<double>& all, const std::vector<double>& own);
  void measure();
  std::vector<double> ambient() const;
  size_t brightest(const std::vector<double>& ambient) const;
  std::vector<uint32_t> move_to(const RadiosityProblem& next, std::span<const uint32_t> origins);
  void send(const std::vector<uint32_t>& to, std::span<const double> factors, std::span<const double> all,
            std::span<const double> own);
  void settle(const std::vector<double>& shot);

  const RadiosityProblem* p_;
  Shot shot_;
  RadiosityState state_;
  std::vector<uint8_t> emission_left_;
  std::vector<double> power_, received_, factors_;
  std::vector<double> reflecting_;  // by shooter and band: area times reflectance
};

}  // namespace aktina
