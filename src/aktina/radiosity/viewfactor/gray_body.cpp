#include "aktina/radiosity/viewfactor/gray_body.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"

namespace aktina {
namespace {

constexpr size_t kMostSurfaces = 20000;  // three matrices of them are 9.6 GB

void check(const ViewFactors& factors, const std::vector<GrayBody>& bodies) {
  const size_t n = factors.size();
  if (bodies.size() != n)
    throw Error(Code::usage, "bodies", fmt::format("there are {}", bodies.size()), fmt::format("{} surfaces", n));
  if (n > kMostSurfaces)
    throw Error(Code::limit, "surfaces", fmt::format("there are {}", n),
                fmt::format("grey-body exchange takes at most {}", kMostSurfaces));
  for (size_t i = 0; i < n; ++i)
    if (!(bodies[i].emissivity > 0 && bodies[i].emissivity <= 1))
      throw Error(Code::bad_param, factors.names[i], fmt::format("has the emissivity {}", bodies[i].emissivity),
                  "above 0, at most 1");
}

/// Solves matrix x = right for several right-hand sides in place, by elimination with row exchange.
class DirectSolver {
 public:
  DirectSolver(size_t n, size_t columns) : n_(n), columns_(columns), a_(n * n, 0), b_(n * columns, 0) {}
  double& matrix(size_t i, size_t j) { return a_[i * n_ + j]; }
  double& right(size_t i, size_t k) { return b_[i * columns_ + k]; }

  /// False where the matrix is singular.
  bool solve() {
    double scale = 0;
    for (const double value : a_) scale = std::max(scale, std::abs(value));
    for (size_t k = 0; k < n_; ++k) {
      size_t pivot = k;
      for (size_t i = k + 1; i < n_; ++i)
        if (std::abs(matrix(i, k)) > std::abs(matrix(pivot, k))) pivot = i;
      if (!(std::abs(matrix(pivot, k)) > 1e-13 * scale)) return false;
      if (pivot != k) {
        std::swap_ranges(&matrix(k, 0), &matrix(k, 0) + n_, &matrix(pivot, 0));
        std::swap_ranges(&right(k, 0), &right(k, 0) + columns_, &right(pivot, 0));
      }
      parallel_for(n_ - k - 1, 64, [&](size_t begin, size_t end) {
        for (size_t i = k + 1 + begin; i < k + 1 + end; ++i) eliminate(i, k, k + 1);
      });
    }
    parallel_for(columns_, 64, [&](size_t begin, size_t end) {
      for (size_t i = n_; i-- > 0;) {
        for (size_t j = i + 1; j < n_; ++j)
          if (const double factor = matrix(i, j); factor != 0)
            for (size_t c = begin; c < end; ++c) right(i, c) -= factor * right(j, c);
        for (size_t c = begin; c < end; ++c) right(i, c) /= matrix(i, i);
      }
    });
    return true;
  }

 private:
  void eliminate(size_t i, size_t k, size_t from) {
    const double factor = matrix(i, k) / matrix(k, k);
    if (factor == 0) return;
    for (size_t j = from; j < n_; ++j) matrix(i, j) -= factor * matrix(k, j);
    for (size_t c = 0; c < columns_; ++c) right(i, c) -= factor * right(k, c);
  }

  size_t n_, columns_;
  std::vector<double> a_, b_;
};

}  // namespace

GrayExchange gray_exchange(const ViewFactors& factors, const std::vector<GrayBody>& bodies) {
  check(factors, bodies);
  const size_t n = factors.size();
  DirectSolver system(n, n);
  for (size_t i = 0; i < n; ++i) {
    system.matrix(i, i) = 1;
    for (uint64_t k = factors.starts[i]; k < factors.starts[i + 1]; ++k) {
      const size_t j = factors.columns[k];
      system.matrix(i, j) -= factors.factors[k] * (1 - bodies[j].emissivity);
      system.right(i, j) = factors.factors[k] * bodies[j].emissivity;
    }
  }
  if (!system.solve()) throw Error(Code::bad_input, "view factors", "have no finite exchange");
  GrayExchange result{n, std::vector<double>(n * n), std::vector<double>(n * n), std::vector<double>(n)};
  for (size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (size_t j = 0; j < n; ++j) {
      result.gebhart[i * n + j] = system.right(i, j);
      result.script_f[i * n + j] = bodies[i].emissivity * system.right(i, j);
      sum += system.right(i, j);
    }
    result.escaped[i] = 1 - sum;
  }
  return result;
}

GrayBalance gray_balance(const ViewFactors& factors, const std::vector<GrayBody>& bodies, double surroundings) {
  check(factors, bodies);
  if (!(surroundings >= 0) || !std::isfinite(surroundings))
    throw Error(Code::bad_param, "surroundings", fmt::format("got {} K", surroundings), "0 or more");
  const size_t n = factors.size();
  DirectSolver system(n, 1);
  const double sky = kStefanBoltzmann * std::pow(surroundings, 4);
  for (size_t i = 0; i < n; ++i) {
    const GrayBody& body = bodies[i];
    const bool warm = std::isfinite(body.temperature), heated = std::isfinite(body.flux);
    if (warm == heated)
      throw Error(Code::bad_param, factors.names[i], warm ? "has temperature and flux" : "has no temperature or flux",
                  "one of them");
    if (warm && body.temperature < 0)
      throw Error(Code::bad_param, factors.names[i], fmt::format("has {} K", body.temperature), "0 or more");
    // Either e sigma T^4 + (1 - e) H, or q + H; H = sum_j F_ij J_j + the rest of the row times what comes from outside.
    const double reflects = warm ? 1 - body.emissivity : 1;
    const double open = std::max(0.0, 1 - factors.row_sum(i));
    system.matrix(i, i) = 1;
    for (uint64_t k = factors.starts[i]; k < factors.starts[i + 1]; ++k)
      system.matrix(i, factors.columns[k]) -= reflects * factors.factors[k];
    system.right(i, 0) =
        reflects * open * sky + (warm ? body.emissivity * kStefanBoltzmann * std::pow(body.temperature, 4) : body.flux);
  }
  if (!system.solve())
    throw Error(Code::bad_input, "surfaces", "have no balance", "give at least one of them a temperature");
  GrayBalance balance;
  for (size_t i = 0; i < n; ++i) balance.radiosities.push_back(system.right(i, 0));
  for (size_t i = 0; i < n; ++i) {
    double arriving = std::max(0.0, 1 - factors.row_sum(i)) * sky;
    for (uint64_t k = factors.starts[i]; k < factors.starts[i + 1]; ++k)
      arriving += factors.factors[k] * balance.radiosities[factors.columns[k]];
    const double flux = balance.radiosities[i] - arriving, e = bodies[i].emissivity;
    // J = e sigma T^4 + (1 - e) H
    const double emitted = arriving + flux / e;
    if (emitted < -1e-9 * std::abs(arriving))
      throw Error(Code::bad_param, factors.names[i], "would have to be colder than 0 K to lose so little", "its flux");
    balance.fluxes.push_back(flux);
    const double given = bodies[i].temperature;
    balance.temperatures.push_back(std::isfinite(given) ? given
                                                        : std::pow(std::max(emitted, 0.0) / kStefanBoltzmann, 0.25));
    balance.net += factors.areas[i] * flux;
  }
  return balance;
}

}  // namespace aktina
