// Biquadratic normals: one quadratic through the corners' normals and a normal in the middle of each edge that serves
// arcs and S-shaped edges alike. Neighbours agree on their edge and the result does not depend on the direction of
// scanning. Cost: quadratic polynomial, square root and model a pixel. Weakness: a second set of normals to set up.
// In the manner of the publication, whose details could not be read.
//
// Y.-C. Lee, C.-W. Jen, "Improved Quadratic Normal Vector Interpolation for Realistic Shading", The Visual Computer
// 17(6), 2001.
#include "aktina/raster/shading/edge_normals.h"

namespace aktina {
namespace {

Vec3 middle(Vec3 n0, Vec3 n1, Vec3 edge) {
  const Vec3 sum = n0 + n1;
  const float e2 = dot(edge, edge);
  return normalize_or(e2 > 0 ? 0.75f * sum - edge * (dot(edge, sum) / e2) : sum, n0);
}

}  // namespace

extern constinit const ShadingRow lee_jen_shading = {
    {"lee_jen", "Lee and Jen's biquadratic normals", "lee2001",
     "Quadratic normals that serve arcs and S-shaped edges; little dearer than Phong."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return edge_normal_shading(middle, false); }};

}  // namespace aktina
