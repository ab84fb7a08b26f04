// The matrix method: all form factors first, then Gauss-Seidel sweeps until nothing changes.
// Cost: memory of receivers times shooters, the same in time a sweep; few sweeps. Weakness: nothing to see before all
// form factors are known, and they must fit into memory.
//
// C. Goral, K. Torrance, D. Greenberg, B. Battaile, "Modeling the Interaction of Light Between Diffuse Surfaces",
// SIGGRAPH 1984.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/radiosity/solver/solver.h"

namespace aktina {
namespace {

constexpr double kMostEntries = 1 << 28;  // 2 GiB
constexpr uint64_t kMostSweeps = 10'000;  // reflectance 0.997 at a tolerance of 1e-12

class System {
 public:
  System(const RadiosityProblem& p, const FactorSource& source, const SolverControl& control)
      : p_(p), columns_(p.shooters.size()) {
    if (double(p.size()) * double(columns_) > kMostEntries)
      throw Error(Code::limit, "matrix", fmt::format("{} x {} form factors", p.size(), columns_),
                  "larger patches, or the progressive solver");
    factors_.resize(p.size() * columns_);
    std::vector<double> column(p.size());
    if (control.progress) control.progress->begin("form factors", "columns", columns_);
    for (size_t j = 0; j < columns_ && !control.stopped(0); ++j) {
      source.column(j, column);
      for (size_t s = 0; s < p.size(); ++s) factors_[s * columns_ + j] = column[s];
      if (control.progress) control.progress->advance();
    }
    state.emitted = p.emitted();
    state.direct = gathered(means(p.emissions));
    state.irradiances.resize(p.size() * p.bands, 0);
    means_ = means(p.emissions);
    contraction_ = contraction();
  }

  /// One sweep. Returns a bound of the error that is left, relative to the largest radiosity.
  double sweep() {
    double change = 0, largest = 0;
    for (size_t j = 0; j < columns_; ++j) {
      const auto range = p_.shooters[j];
      for (size_t s = range.first; s < range.first + range.count; ++s) gather(s);
      for (size_t b = 0; b < p_.bands; ++b) {
        const double mean = mean_radiosity(range, b);
        change = std::max(change, std::abs(mean - means_[j * p_.bands + b]));
        largest = std::max(largest, mean);
        means_[j * p_.bands + b] = mean;
      }
    }
    ++state.steps;
    return largest > 0 ? change * contraction_ / (1 - contraction_) / largest : 0;
  }

  /// Energy accounting: what the last sweep has not carried on counts as not yet distributed.
  void account() {
    state.unshot.assign(p_.size() * p_.bands, 0);
    const std::vector<double> next = gathered(means_);
    for (size_t k = 0; k < next.size(); ++k) state.unshot[k] = p_.reflectances[k] * (next[k] - state.irradiances[k]);
    state.irradiances = next;
    state.absorbed = absorbed_flux(p_, state);
    const double left = unshot_flux(p_, state);
    state.unshot_share = state.emitted > 0 ? std::abs(left) / state.emitted : 0;
    state.escaped = state.emitted - state.absorbed - left;
  }

  RadiosityState state;

 private:
  double arriving(size_t k) const { return p_.arriving.empty() ? 0 : p_.arriving[k]; }

  std::vector<double> means(const std::vector<double>& values) const {
    std::vector<double> sums(columns_ * p_.bands, 0);
    for (size_t j = 0; j < columns_; ++j) {
      const auto range = p_.shooters[j];
      double area = 0;
      for (size_t s = range.first; s < range.first + range.count; ++s) {
        area += p_.areas[s];
        for (size_t b = 0; b < p_.bands; ++b) sums[j * p_.bands + b] += p_.areas[s] * values[s * p_.bands + b];
      }
      for (size_t b = 0; b < p_.bands; ++b) sums[j * p_.bands + b] /= area;
    }
    return sums;
  }

  std::vector<double> gathered(const std::vector<double>& radiosities) const {
    std::vector<double> h(p_.size() * p_.bands);
    parallel_for(p_.size(), 64, [&](size_t begin, size_t end) {
      for (size_t s = begin; s < end; ++s)
        for (size_t b = 0; b < p_.bands; ++b) {
          double sum = arriving(s * p_.bands + b);
          for (size_t j = 0; j < columns_; ++j) sum += factors_[s * columns_ + j] * radiosities[j * p_.bands + b];
          h[s * p_.bands + b] = sum;
        }
    });
    return h;
  }

  /// A concave receiver sees itself: its own share moves to the other side of the equation.
  void gather(size_t s) {
    const size_t own = shooter_of(s);
    const bool alone = p_.shooters[own].count == 1;
    for (size_t b = 0; b < p_.bands; ++b) {
      const size_t k = s * p_.bands + b;
      const double* row = &factors_[s * columns_];
      double sum = arriving(k);
      for (size_t j = 0; j < columns_; ++j) sum += row[j] * means_[j * p_.bands + b];
      if (alone) {
        const double others = sum - row[own] * means_[own * p_.bands + b];
        sum = (others + row[own] * p_.emissions[k]) / (1 - p_.reflectances[k] * row[own]);
      }
      state.irradiances[k] = sum;
    }
  }

  size_t shooter_of(size_t s) const {
    const auto after = std::upper_bound(p_.shooters.begin(), p_.shooters.end(), s,
                                        [](size_t value, const auto& range) { return value < range.first; });
    return size_t(after - p_.shooters.begin()) - 1;
  }

  double mean_radiosity(RadiosityProblem::Range range, size_t b) const {
    double sum = 0, area = 0;
    for (size_t s = range.first; s < range.first + range.count; ++s) {
      sum += p_.areas[s] * state.radiosity(p_, s, b);
      area += p_.areas[s];
    }
    return sum / area;
  }

  /// A sweep shrinks the largest error at least by this: the largest rho times row sum.
  double contraction() const {
    double largest = 0;
    for (size_t s = 0; s < p_.size(); ++s) {
      double sum = 0;
      for (size_t j = 0; j < columns_; ++j) sum += factors_[s * columns_ + j];
      for (size_t b = 0; b < p_.bands; ++b) largest = std::max(largest, sum * p_.reflectances[s * p_.bands + b]);
    }
    return std::min(largest, 0.999999);
  }

  const RadiosityProblem& p_;
  size_t columns_;
  std::vector<double> factors_, means_;
  double contraction_ = 0;
};

class MatrixSolver final : public RadiositySolver {
 public:
  RadiosityState solve(const RadiosityProblem& problem, const FactorSource& factors,
                       const SolverControl& control) const override {
    System system(problem, factors, control);
    RadiosityState& state = system.state;
    if (control.progress) control.progress->begin("solving", "sweeps", 0);
    double left = 1;
    while (left > control.tolerance && state.steps < kMostSweeps && !control.stopped(state.steps)) {
      left = system.sweep();
      if (control.progress) control.progress->advance();
      if (control.each_step) {
        system.account();
        control.each_step(state);
      }
    }
    system.account();
    state.converged = left <= control.tolerance;
    return std::move(state);
  }
};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> matrix_radiosity = {
    {"matrix", "Matrix radiosity by Gauss-Seidel", "goral1984",
     "All form factors, then a linear system: exact for its factors, memory grows with the square of the patches."},
    [](const ParamSet&) -> std::unique_ptr<RadiositySolver> { return std::make_unique<MatrixSolver>(); }};

}  // namespace aktina
