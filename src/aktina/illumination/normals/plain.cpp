// Mean of the unit facet normals, each facet counted once.
// Cost: one square root a facet. Weakness: changes when a facet is cut in two within its plane.
//
// H. Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on Computers C-20(6), 1971.
#include <cmath>

#include "aktina/illumination/normals/normals.h"

namespace aktina {
namespace {

Vec3d weighted(const FacetCorner& corner) {
  const Vec3d c = cross(corner.next, corner.previous);
  const double norm = length(c);
  return norm > 0 ? c / norm : Vec3d(0);
}

}  // namespace

extern constinit const Method<FacetWeighting> plain_normals = {
    {"plain", "Mean of facet normals", "gouraud1971",
     "Every facet counts once, one square root a facet; depends on how the facets are cut."},
    [](const ParamSet&) -> FacetWeighting { return weighted; }};

}  // namespace aktina
