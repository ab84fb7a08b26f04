// Quadratic normals that follow the edges of the surface: along each edge a Bezier curve whose middle control normal is
// the sum of the end normals mirrored in the plane across the edge, so that the mean of N.E along the edge is zero.
// An S-shaped edge with equal end normals, flat to Phong, is shaded right. Cost: quadratic polynomial, square root and
// model a pixel. Weakness: plain arcs get worse than by linear interpolation (3.3 against 1.1 degrees over 60).
// In the manner of the publication, whose exact coefficients could not be read.
//
// C. W. A. M. van Overveld, B. Wyvill, "Phong Normal Interpolation Revisited", ACM Transactions on Graphics 16(4),
// 1997.
#include "aktina/raster/shading/edge_normals.h"

namespace aktina {
namespace {

/// (1 - t)^2 N0 + 2 t (1 - t) M + t^2 N1 at t = 1/2.
Vec3 middle(Vec3 n0, Vec3 n1, Vec3 edge) {
  const Vec3 sum = n0 + n1;
  const float e2 = dot(edge, edge);
  const Vec3 mirrored = e2 > 0 ? sum - edge * (2 * dot(edge, sum) / e2) : sum;
  return 0.25f * sum + 0.5f * mirrored;
}

}  // namespace

extern constinit const ShadingRow overveld_wyvill_shading = {
    {"overveld_wyvill", "van Overveld and Wyvill's quadratic normals", "overveld1997",
     "Normals that follow S-shaped edges; plain arcs get worse than by Phong."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return edge_normal_shading(middle, false); }};

}  // namespace aktina
