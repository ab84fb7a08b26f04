// What the wavelet solvers share: all but the basis.
//
// Light is kept in the functions of each node of the tree; what a level adds to the one above are wavelets. Links join
// nodes of any two levels (the non-standard form of the operator): where the kernel between two nodes is what the
// basis makes of it, its wavelet coefficients vanish and finer links add nothing.
//
// S. Gortler, P. Schroeder, M. Cohen, P. Hanrahan, "Wavelet Radiosity", SIGGRAPH '93.
#pragma once

#include <memory>

#include "aktina/radiosity/solver/hierarchy/basis.h"
#include "aktina/radiosity/solver/solver.h"

namespace aktina {

/// @param method  for messages
/// @param most    share of the scene's flux that a link may carry wrongly at a target error of 1
std::unique_ptr<RadiositySolver> wavelet_solver(std::string_view method, Basis basis, double most);

}  // namespace aktina
