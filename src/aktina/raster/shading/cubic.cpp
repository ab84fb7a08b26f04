// The illumination model at ten points of a triangle, and the cubic polynomial through them.
// Cost: ten evaluations a triangle (shared at corners and edges), three additions a pixel and channel.
// Weakness: as many evaluations as nine small Gouraud triangles, and hardly better than they are; swings more than the
// quadratic where a highlight is sharp.
//
// D. Vlasic, "Fake Phong Shading", MIT 2002.
#include "aktina/raster/shading/light_lattice.h"

namespace aktina {
namespace {

constexpr Param kParams[] = {
    {"perspective", "1", "1: cubic on the surface; 0: cubic on the screen, as published", 0, 0, 1, true}};

}  // namespace

extern constinit const ShadingRow cubic_shading = {
    {"cubic", "Cubic shading", "vlasic2002",
     "A cubic through ten lit samples; hardly better than nine Gouraud triangles of the same cost.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<ShadingMethod> { return polynomial_shading(3, p["perspective"] != 0); }};

}  // namespace aktina
