// Wavelet radiosity in multiwavelets M2: linear in each direction, four functions on a parallelogram, 1, x, y on a
// triangle. Cost: 16 coefficients (80 bytes) a link, 2 x 2 Gauss points on each node. Weakness: one share of visibility
// for all coefficients, so shadows are as blocky as Haar's, while each link costs five times as much.
//
// S. Gortler, P. Schroeder, M. Cohen, P. Hanrahan, "Wavelet Radiosity", SIGGRAPH '93.
#include "aktina/radiosity/solver/hierarchy/wavelet.h"

namespace aktina {

extern constinit const Method<std::unique_ptr<RadiositySolver>> wavelet_m2_radiosity = {
    {"wavelet_m2", "Wavelet radiosity, multiwavelets M2", "gortler1993",
     "Linear light on quadtrees; far fewer links than Haar where nothing is in the way, each of them larger."},
    [](const ParamSet&) { return wavelet_solver("wavelet_m2", Basis::polynomials(2), 0.06); }};

}  // namespace aktina
