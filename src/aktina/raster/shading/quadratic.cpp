// The illumination model at the corners and at the middles of the edges, and the quadratic polynomial through the six
// values. Cost: six evaluations a triangle (those of the corners and edges are shared by neighbours), two additions a
// pixel and channel. It can have a maximum inside of the triangle, which Gouraud's plane cannot.
// Weakness: sharp highlights (exponents above about 30) are missed or swing below zero; the first derivative still
// jumps at edges.
//
// D. Vlasic, "Fake Phong Shading", MIT 2002; Szirmay-Kalos et al., "Quadratic Shading and its Hardware
// Implementation", Machine Graphics and Vision 9(4), 2000.
#include "aktina/raster/shading/light_lattice.h"

namespace aktina {
namespace {

constexpr Param kParams[] = {
    {"perspective", "1", "1: quadratic on the surface; 0: quadratic on the screen, as published", 0, 0, 1, true}};

}  // namespace

extern constinit const ShadingRow quadratic_shading = {
    {"quadratic", "Quadratic shading", "szirmay2000",
     "A quadratic through six lit samples; shows highlights inside of a triangle that are not too sharp.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<ShadingMethod> { return polynomial_shading(2, p["perspective"] != 0); }};

}  // namespace aktina
