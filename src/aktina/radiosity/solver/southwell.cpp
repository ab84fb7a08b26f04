// Southwell's relaxation: always the row with the largest residual; a sweep is as many relaxations as there are rows.
// Progressive refinement is this with all form factors computed as they are needed: the residual is the light not yet
// shot. Cost: a column of the matrix a relaxation. Weakness: columns lie scattered in memory, and the largest residual
// has to be looked for.
//
// R. Southwell, "Relaxation Methods in Engineering Science", Oxford University Press 1940; as shooting: S. Gortler,
// M. Cohen, P. Slusallek, "Radiosity and Relaxation Methods", IEEE CG&A 14(6), 1994.
#include <algorithm>
#include <cmath>

#include "aktina/radiosity/solver/matrix_iteration.h"

namespace aktina {
namespace {

class Southwell final : public MatrixIteration {
 public:
  void sweep(BandSystem& s) override {
    const size_t n = s.x.size();
    for (size_t k = 0; k < n; ++k) {
      const auto weight = [&](size_t j) { return s.matrix.area(j) * std::abs(s.residual[j]); };
      size_t i = 0;
      for (size_t j = 1; j < n; ++j)
        if (weight(j) > weight(i)) i = j;
      if (s.residual[i] == 0) return;
      const double change = s.residual[i] / (1 - s.matrix.entry(i, i, s.band));
      s.x[i] += change;
      s.residual[i] -= change;
      for (size_t j = 0; j < n; ++j) s.residual[j] += s.matrix.entry(j, i, s.band) * change;
    }
  }
};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> southwell_radiosity = {
    {"southwell", "Southwell's relaxation", "gortler1994",
     "All form factors, then always the patch with the most light not yet distributed; good first sweeps."},
    [](const ParamSet&) -> std::unique_ptr<RadiositySolver> {
      return std::make_unique<MatrixSolver<Southwell>>(Southwell());
    }};

}  // namespace aktina
