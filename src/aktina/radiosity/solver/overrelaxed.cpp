// Successive overrelaxation: Gauss-Seidel whose changes are taken larger than they are. Cost: as Gauss-Seidel, fewer
// sweeps where reflectances are high. Weakness: the best factor is not known beforehand; above it convergence is
// slower, and from 2 on there is none.
//
// D. Young, "Iterative Methods for Solving Partial Difference Equations of Elliptic Type", Transactions of the American
// Mathematical Society 76, 1954.
#include "aktina/radiosity/solver/matrix_iteration.h"

namespace aktina {
namespace {

class Overrelaxation final : public MatrixIteration {
 public:
  explicit Overrelaxation(double factor) : factor_(factor) {}
  void sweep(BandSystem& s) override {
    for (size_t j = 0; j < s.x.size(); ++j) {
      const double change = s.right_side[j] + s.matrix.row_times(j, s.band, s.x) - s.x[j];
      s.x[j] += factor_ * change / (1 - s.matrix.entry(j, j, s.band));
    }
  }

 private:
  double factor_;
};

constexpr Param kParams[] = {{"factor", "1", "by which changes are enlarged; 1: Gauss-Seidel", 1.2, 0.1, 1.9}};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> overrelaxed_radiosity = {
    {"overrelaxed", "Successive overrelaxation", "young1954",
     "Gauss-Seidel with larger steps: fewer sweeps in bright rooms, more where the factor does not fit.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<RadiositySolver> {
      return std::make_unique<MatrixSolver<Overrelaxation>>(Overrelaxation(p["factor"]));
    }};

}  // namespace aktina
