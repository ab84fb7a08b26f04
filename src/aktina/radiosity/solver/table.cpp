// The radiosity solvers: the only list.
#include "aktina/radiosity/solver/solver.h"

namespace aktina {

extern const RadiositySolverRow stochastic_jacobi_radiosity, progressive_radiosity, overshooting_radiosity,
    substructured_radiosity, matrix_radiosity, jacobi_radiosity, overrelaxed_radiosity, southwell_radiosity,
    conjugate_gradient_radiosity, gmres_radiosity, hierarchical_radiosity, clustering_radiosity, wavelet_haar_radiosity,
    wavelet_m2_radiosity, wavelet_m3_radiosity, wavelet_f2_radiosity;

std::span<const RadiositySolverRow* const> solvers() {
  static constexpr const RadiositySolverRow* kTable[] = {&stochastic_jacobi_radiosity,
                                                         &progressive_radiosity,
                                                         &overshooting_radiosity,
                                                         &substructured_radiosity,
                                                         &matrix_radiosity,
                                                         &jacobi_radiosity,
                                                         &overrelaxed_radiosity,
                                                         &southwell_radiosity,
                                                         &conjugate_gradient_radiosity,
                                                         &gmres_radiosity,
                                                         &hierarchical_radiosity,
                                                         &clustering_radiosity,
                                                         &wavelet_haar_radiosity,
                                                         &wavelet_m2_radiosity,
                                                         &wavelet_m3_radiosity,
                                                         &wavelet_f2_radiosity};
  return kTable;
}

}  // namespace aktina
