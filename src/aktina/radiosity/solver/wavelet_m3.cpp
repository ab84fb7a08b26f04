// Wavelet radiosity in multiwavelets M3: quadratic in each direction, nine functions on a parallelogram, six on a
// triangle. Cost: 81 coefficients (340 bytes) a link, 3 x 3 Gauss points on each node. Weakness: memory; shadows gain
// nothing.
//
// S. Gortler, P. Schroeder, M. Cohen, P. Hanrahan, "Wavelet Radiosity", SIGGRAPH '93.
#include "aktina/radiosity/solver/hierarchy/wavelet.h"

namespace aktina {

extern constinit const Method<std::unique_ptr<RadiositySolver>> wavelet_m3_radiosity = {
    {"wavelet_m3", "Wavelet radiosity, multiwavelets M3", "gortler1993",
     "Quadratic light on quadtrees; fewest links in open rooms, and the most memory for each."},
    [](const ParamSet&) { return wavelet_solver("wavelet_m3", Basis::polynomials(3), 0.06); }};

}  // namespace aktina
