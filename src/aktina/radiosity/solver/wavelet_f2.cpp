// Wavelet radiosity in flatlets F2: a box on each quarter of a node, the kernel sampled in the middle of each; wavelets
// with two vanishing moments, for nodes pull up the mean and the first moments of what is below. On a triangle the
// boxes are the four quarters. Cost: 16 coefficients (80 bytes) a link. Weakness: light is in steps as with Haar.
//
// S. Gortler, P. Schroeder, M. Cohen, P. Hanrahan, "Wavelet Radiosity", SIGGRAPH '93.
#include "aktina/radiosity/solver/hierarchy/wavelet.h"

namespace aktina {

extern constinit const Method<std::unique_ptr<RadiositySolver>> wavelet_f2_radiosity = {
    {"wavelet_f2", "Wavelet radiosity, flatlets F2", "gortler1993",
     "Boxes whose sums keep first moments: senders as exact as M2, receivers in steps."},
    [](const ParamSet&) { return wavelet_solver("wavelet_f2", Basis::flatlets(), 0.06); }};

}  // namespace aktina
