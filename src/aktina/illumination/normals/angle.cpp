// Facet normals weighted by the facet's angle at the vertex.
// Cost: a square root and an arc tangent a facet. Strength: cutting a facet within its plane changes nothing.
// Weakness: not exact on a sphere.
//
// G. Thuermer, C. A. Wuethrich, "Computing Vertex Normals from Polygonal Facets", Journal of Graphics Tools 3(1), 1998.
#include <cmath>

#include "aktina/illumination/normals/normals.h"

namespace aktina {
namespace {

Vec3d weighted(const FacetCorner& corner) {
  const Vec3d c = cross(corner.next, corner.previous);
  const double norm = length(c);
  return norm > 0 ? c * (std::atan2(norm, dot(corner.next, corner.previous)) / norm) : Vec3d(0);
}

}  // namespace

extern constinit const Method<FacetWeighting> angle_normals = {
    {"angle", "Facet normals weighted by angle", "thurmer1998",
     "Independent of how the facets are cut, one arc tangent a facet; not exact on a sphere."},
    [](const ParamSet&) -> FacetWeighting { return weighted; }};

}  // namespace aktina
