// The radiosity solvers: the only list.
#include "aktina/radiosity/solver/solver.h"

namespace aktina {

extern const RadiositySolverRow progressive_radiosity, matrix_radiosity;

std::span<const RadiositySolverRow* const> solvers() {
  static constexpr const RadiositySolverRow* kTable[] = {&progressive_radiosity, &matrix_radiosity};
  return kTable;
}

}  // namespace aktina
