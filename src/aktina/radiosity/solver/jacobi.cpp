// Jacobi iteration: every patch gathers from the radiosities of the sweep before; each sweep is one more reflection.
// Cost: one product with the matrix a sweep, all rows at once. Weakness: about twice the sweeps of Gauss-Seidel.
//
// Y. Saad, "Iterative Methods for Sparse Linear Systems", 2nd ed., SIAM 2003, section 4.1.
#include "aktina/radiosity/solver/matrix_iteration.h"

namespace aktina {
namespace {

class Jacobi final : public MatrixIteration {
 public:
  void sweep(BandSystem& s) override {
    for (size_t j = 0; j < s.x.size(); ++j) s.x[j] += s.residual[j] / (1 - s.matrix.entry(j, j, s.band));
  }
};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> jacobi_radiosity = {
    {"jacobi", "Jacobi iteration", "saad2003",
     "All form factors, then one reflection a sweep; simple, all rows at once, slower to converge than Gauss-Seidel."},
    [](const ParamSet&) -> std::unique_ptr<RadiositySolver> {
      return std::make_unique<MatrixSolver<Jacobi>>(Jacobi());
    }};

}  // namespace aktina
