// The matrix method: all form factors first, then Gauss-Seidel sweeps until nothing changes.
// Cost: memory of receivers times shooters, the same in time a sweep; few sweeps. Weakness: nothing to see before all
// form factors are known, and they must fit into memory; rows wait for each other, so sweeps use one thread.
//
// C. Goral, K. Torrance, D. Greenberg, B. Battaile, "Modeling the Interaction of Light Between Diffuse Surfaces",
// SIGGRAPH 1984; by Gauss-Seidel: M. Cohen, D. Greenberg, "The Hemi-cube", SIGGRAPH 1985.
#include "aktina/radiosity/solver/matrix_iteration.h"

namespace aktina {
namespace {

/// Each row takes what it needs from the rows before it. A concave receiver sees itself: its own share moves to the
/// other side of the equation.
class GaussSeidel final : public MatrixIteration {
 public:
  void sweep(BandSystem& s) override {
    for (size_t j = 0; j < s.x.size(); ++j) {
      const double change = s.right_side[j] + s.matrix.row_times(j, s.band, s.x) - s.x[j];
      s.x[j] += change / (1 - s.matrix.entry(j, j, s.band));
    }
  }
};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> matrix_radiosity = {
    {"matrix", "Matrix radiosity by Gauss-Seidel", "goral1984",
     "All form factors, then a linear system: exact for its factors, memory grows with the square of the patches."},
    [](const ParamSet&) -> std::unique_ptr<RadiositySolver> {
      return std::make_unique<MatrixSolver<GaussSeidel>>(GaussSeidel());
    }};

}  // namespace aktina
