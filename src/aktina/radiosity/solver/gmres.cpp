// Generalised minimal residual: the best combination of all light distributions K^i E seen so far; started again after
// `restart` steps. Cost: one product with the matrix a step, and products with all directions kept. Weakness: memory
// for the directions.
//
// Y. Saad, M. Schultz, "GMRES: A Generalized Minimal Residual Algorithm for Solving Nonsymmetric Linear Systems", SIAM
// Journal on Scientific and Statistical Computing 7(3), 1986.
#include <algorithm>
#include <cmath>

#include "aktina/radiosity/solver/matrix_iteration.h"

namespace aktina {
namespace {

using Vector = std::vector<double>;

double dot(const Vector& a, const Vector& b) {
  double sum = 0;
  for (size_t j = 0; j < a.size(); ++j) sum += a[j] * b[j];
  return sum;
}

class Gmres final : public MatrixIteration {
 public:
  explicit Gmres(size_t restart) : restart_(restart) {}

  void sweep(BandSystem& s) override {
    if (basis_.empty() || columns_.size() == restart_) start(s);
    if (basis_.empty()) return;
    Vector next = s.matrix.times(s.band, basis_.back());
    for (size_t j = 0; j < next.size(); ++j) next[j] = basis_.back()[j] - next[j];
    Vector column;
    for (const Vector& v : basis_) {  // modified Gram-Schmidt
      column.push_back(dot(next, v));
      for (size_t j = 0; j < next.size(); ++j) next[j] -= column.back() * v[j];
    }
    const double length = std::sqrt(dot(next, next));
    rotate(column, length);
    columns_.push_back(column);
    combine(s);
    if (!(length > 1e-14 * first_)) {
      basis_.clear();
      return;
    }
    for (double& v : next) v /= length;
    basis_.push_back(std::move(next));
  }

  void archive(Archive& a, size_t n) override {
    a(first_), a.any_length(start_), a.any_length(right_), a.any_length(cosines_), a.any_length(sines_);
    a.any_length(basis_), a.any_length(columns_);
    const size_t steps = columns_.size();
    a.expect(steps <= restart_ && cosines_.size() == steps && sines_.size() == steps);
    if (basis_.empty()) return;
    a.expect(start_.size() == n && right_.size() == steps + 1 && basis_.size() == steps + 1);
    for (const Vector& v : basis_) a.expect(v.size() == n);
    for (size_t i = 0; i < steps; ++i) a.expect(columns_[i].size() == i + 1);
  }

 private:
  void start(const BandSystem& s) {
    basis_.clear(), columns_.clear(), cosines_.clear(), sines_.clear();
    first_ = std::sqrt(dot(s.residual, s.residual));
    if (!(first_ > 0)) return;
    start_ = s.x, right_ = {first_};
    basis_.push_back(s.residual);
    for (double& v : basis_.back()) v /= first_;
  }

  /// Givens rotations make the new column of the Hessenberg matrix upper triangular.
  void rotate(Vector& column, double below) {
    for (size_t i = 0; i < cosines_.size(); ++i) {
      const double upper = column[i], lower = column[i + 1];
      column[i] = cosines_[i] * upper + sines_[i] * lower;
      column[i + 1] = cosines_[i] * lower - sines_[i] * upper;
    }
    const double length = std::hypot(column.back(), below);
    cosines_.push_back(length > 0 ? column.back() / length : 1);
    sines_.push_back(length > 0 ? below / length : 0);
    column.back() = length;
    const double last = right_.back();
    right_.back() = cosines_.back() * last;
    right_.push_back(-sines_.back() * last);
  }

  /// x = start + basis y, where y makes the residual smallest.
  void combine(BandSystem& s) const {
    Vector y(right_.begin(), right_.end() - 1);
    for (size_t i = y.size(); i-- > 0;) {
      for (size_t k = i + 1; k < y.size(); ++k) y[i] -= columns_[k][i] * y[k];
      y[i] = columns_[i][i] > 0 ? y[i] / columns_[i][i] : 0;
    }
    s.x = start_;
    for (size_t i = 0; i < y.size(); ++i)
      for (size_t j = 0; j < s.x.size(); ++j) s.x[j] += y[i] * basis_[i][j];
  }

  size_t restart_;
  double first_ = 0;
  Vector start_, right_, cosines_, sines_;
  std::vector<Vector> basis_, columns_;
};

constexpr Param kParams[] = {{"restart", "1", "steps after which the directions are forgotten", 30, 2, 200, true}};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> gmres_radiosity = {
    {"gmres", "Generalised minimal residual", "saad1986",
     "All form factors, then the smallest residual over all directions kept; robust, a little memory more.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<RadiositySolver> {
      return std::make_unique<MatrixSolver<Gmres>>(Gmres(size_t(p["restart"])));
    }};

}  // namespace aktina
