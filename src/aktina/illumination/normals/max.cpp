// Facet normals weighted by the sine of the angle over the product of the edge lengths: small facets count more.
// Cost: a division a facet. Strength: exact for vertices on a sphere. Weakness: depends on how the facets are cut.
//
// N. Max, "Weights for Computing Vertex Normals from Facet Normals", Journal of Graphics Tools 4(2), 1999.
#include "aktina/illumination/normals/normals.h"

namespace aktina {
namespace {

Vec3d weighted(const FacetCorner& corner) {
  const double lengths = squared_length(corner.next) * squared_length(corner.previous);
  return lengths > 0 ? cross(corner.next, corner.previous) / lengths : Vec3d(0);
}

}  // namespace

extern constinit const Method<FacetWeighting> max_normals = {
    {"max", "Facet normals by Max's weights", "max1999",
     "Exact for vertices on a sphere, one division a facet; depends on how the facets are cut."},
    [](const ParamSet&) -> FacetWeighting { return weighted; }};

}  // namespace aktina
