// Facet normals weighted by area: the plain sum of the cross products.
// Cost: a cross product a facet, the cheapest. Weakness: one large facet outweighs the small ones that follow the
// surface more closely.
//
// G. Thuermer, C. A. Wuethrich, "Computing Vertex Normals from Polygonal Facets", Journal of Graphics Tools 3(1), 1998
// (as the method they compare with).
#include "aktina/illumination/normals/normals.h"

namespace aktina {
namespace {

Vec3d weighted(const FacetCorner& corner) { return cross(corner.next, corner.previous); }

}  // namespace

extern constinit const Method<FacetWeighting> area_normals = {
    {"area", "Facet normals weighted by area", "thurmer1998",
     "Sum of the cross products, the cheapest; large facets outweigh small ones."},
    [](const ParamSet&) -> FacetWeighting { return weighted; }};

}  // namespace aktina
