// Conjugate gradients. Rows of (I - K) B = E times area over reflectance give a symmetric, positive definite matrix
// A/rho - A F where form factors keep reciprocity; what they violate it by is averaged away, and made good by starting
// again from the true residual. Black patches take no part: their radiosity is their emission.
// Cost: one product with the matrix a step. Weakness: gains over Gauss-Seidel only where reflectances are high.
//
// M. Hestenes, E. Stiefel, "Methods of Conjugate Gradients for Solving Linear Systems", Journal of Research of the
// National Bureau of Standards 49(6), 1952.
#include <algorithm>

#include "aktina/base/parallel.h"
#include "aktina/radiosity/solver/matrix_iteration.h"

namespace aktina {
namespace {

constexpr double kBlack = 1e-12;   // reflectances below take no part
constexpr double kRestart = 1e-6;  // of the first squared residual: from there the true one is asked for again

class ConjugateGradient final : public MatrixIteration {
 public:
  void sweep(BandSystem& s) override {
    if (!(squared_ > kRestart * first_squared_)) start(s);
    const std::vector<double> applied = symmetric_times(s, direction_);
    double curvature = 0;
    for (size_t j = 0; j < applied.size(); ++j) curvature += direction_[j] * applied[j];
    if (!(curvature > 0)) {
      squared_ = 0;
      return;
    }
    const double length = squared_ / curvature;
    for (size_t j = 0; j < applied.size(); ++j) s.x[j] += length * direction_[j], residual_[j] -= length * applied[j];
    const double before = squared_;
    square(s);
    for (size_t j = 0; j < applied.size(); ++j)
      direction_[j] = preconditioned(s, j) + squared_ / before * direction_[j];
  }

  void archive(Archive& a, size_t n) override {
    a.any_length(residual_), a.any_length(direction_), a(squared_), a(first_squared_);
    const bool begun = residual_.size() == n && direction_.size() == n;
    a.expect(begun || (residual_.empty() && direction_.empty() && squared_ == 0 && first_squared_ == 0));
  }

 private:
  /// Area over reflectance: what a row is multiplied by; the diagonal of the symmetric matrix, but for what sees
  /// itself.
  double scale(const BandSystem& s, size_t j) const {
    const double rho = s.matrix.reflectance(j, s.band);
    return rho > kBlack ? s.matrix.area(j) / rho : 0;
  }
  double preconditioned(const BandSystem& s, size_t j) const {
    const double d = scale(s, j);
    return d > 0 ? residual_[j] / d : 0;
  }

  void start(BandSystem& s) {
    const size_t n = s.x.size();
    residual_.resize(n), direction_.resize(n);
    for (size_t j = 0; j < n; ++j) {
      residual_[j] = s.residual[j] * scale(s, j);
      if (scale(s, j) == 0) s.x[j] += s.residual[j];
    }
    square(s);
    first_squared_ = squared_;
    for (size_t j = 0; j < n; ++j) direction_[j] = preconditioned(s, j);
  }

  void square(const BandSystem& s) {
    squared_ = 0;
    for (size_t j = 0; j < residual_.size(); ++j) squared_ += residual_[j] * preconditioned(s, j);
  }

  /// Mean of the scaled matrix and its transpose, times v.
  static std::vector<double> transposed(const BandSystem& s, const std::vector<double>& v) {
    std::vector<double> y(v.size(), 0);
    parallel_for(v.size(), 64, [&](size_t begin, size_t end) {
      for (size_t i = 0; i < v.size(); ++i) {
        if (v[i] == 0) continue;
        for (size_t j = begin; j < end; ++j) y[j] += s.matrix.entry(i, j, s.band) * v[i];
      }
    });
    return y;
  }
  std::vector<double> symmetric_times(const BandSystem& s, const std::vector<double>& v) const {
    const size_t n = v.size();
    std::vector<double> scaled(n);
    for (size_t j = 0; j < n; ++j) scaled[j] = scale(s, j) * v[j];
    const std::vector<double> forward = s.matrix.times(s.band, v), back = transposed(s, scaled);
    std::vector<double> y(n);
    for (size_t j = 0; j < n; ++j) y[j] = scale(s, j) > 0 ? scaled[j] - 0.5 * (scale(s, j) * forward[j] + back[j]) : 0;
    return y;
  }

  std::vector<double> residual_, direction_;
  double squared_ = 0, first_squared_ = 0;
};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> conjugate_gradient_radiosity = {
    {"conjugate_gradient", "Conjugate gradients on the symmetric system", "hestenes1952",
     "All form factors, then conjugate directions: few steps where reflectances are high."},
    [](const ParamSet&) -> std::unique_ptr<RadiositySolver> {
      return std::make_unique<MatrixSolver<ConjugateGradient>>(ConjugateGradient());
    }};

}  // namespace aktina
