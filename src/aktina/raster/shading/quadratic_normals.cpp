// Normals by a quadratic through the corners' and the bisectors at the edges' middles: so nearly of unit length that
// they are used as they are. Cost: two additions a component and the illumination model a pixel; Phong's square root is
// saved. Weakness: over a turn of 60 degrees the length is off by 0.2 % (90 degrees: 1.1 %), which an exponent n
// multiplies by n: fine at a distance, not close up.
//
// L. Szirmay-Kalos, B. Mohamed, et al., "Quadratic Shading and its Hardware Implementation", Machine Graphics and
// Vision 9(4), 2000.
#include "aktina/raster/shading/edge_normals.h"

namespace aktina {
namespace {

Vec3 bisector(Vec3 n0, Vec3 n1, Vec3 /*edge*/) { return normalize_or(n0 + n1, n0); }

}  // namespace

extern constinit const ShadingRow quadratic_normals_shading = {
    {"quadratic_normals", "Quadratic normals without renormalisation", "szirmay2000",
     "Normals that need no square root a pixel; their length is off by 0.2 % over a turn of 60 degrees."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return edge_normal_shading(bisector, true); }};

}  // namespace aktina
