// Wavelet radiosity in Haar's basis, constants: hierarchical radiosity whose oracle compares the kernel with its mean
// at test points. Cost: 16 bytes a link. Weakness: constant elements show their edges; one vanishing moment, so kernels
// that only slope still need fine links.
//
// S. Gortler, P. Schroeder, M. Cohen, P. Hanrahan, "Wavelet Radiosity", SIGGRAPH '93.
#include "aktina/radiosity/solver/hierarchy/wavelet.h"

namespace aktina {

extern constinit const Method<std::unique_ptr<RadiositySolver>> wavelet_haar_radiosity = {
    {"wavelet_haar", "Wavelet radiosity, Haar", "gortler1993",
     "Constants on quadtrees, links where the kernel is nearly constant; cheapest of the wavelets, blocky light."},
    [](const ParamSet&) { return wavelet_solver("wavelet_haar", Basis::polynomials(1), 0.02); }};

}  // namespace aktina
