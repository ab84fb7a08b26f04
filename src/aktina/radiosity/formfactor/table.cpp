// The form-factor methods: the only list.
#include "aktina/radiosity/formfactor/formfactor.h"

namespace aktina {

extern const FormFactorMethodRow contour_formfactor, analytic_formfactor, ray_cast_formfactor, hemicube_formfactor,
    monte_carlo_formfactor, hemisphere_formfactor, single_plane_formfactor, cubic_tetrahedron_formfactor,
    cubature_formfactor, hybrid_formfactor;

std::span<const FormFactorMethodRow* const> formfactors() {
  static constexpr const FormFactorMethodRow* kTable[] = {
      &contour_formfactor,     &analytic_formfactor,   &ray_cast_formfactor,     &hemicube_formfactor,
      &monte_carlo_formfactor, &hemisphere_formfactor, &single_plane_formfactor, &cubic_tetrahedron_formfactor,
      &cubature_formfactor,    &hybrid_formfactor};
  return kTable;
}

}  // namespace aktina
