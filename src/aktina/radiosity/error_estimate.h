// How far a solution may be from the truth, estimated from the solution alone.
#pragma once

#include <vector>

#include "aktina/radiosity/solution.h"

namespace aktina {

/// By patch, lx: estimate of the root mean square difference, over the front of the patch, between its illuminance and
/// that at points of it; from the smooth illuminance that is reconstructed at the vertices, which comes nearer to the
/// truth than constant values do. What was sampled too coarsely to show in the solution is not seen: shadows smaller
/// than patches, noise, light that was not distributed.
/// O. Zienkiewicz, J. Zhu, "A Simple Error Estimator and Adaptive Procedure for Practical Engineering Analysis", Int.
/// J. Numerical Methods in Engineering 24(2), 1987.
/// @param solution  with values at vertices
std::vector<float> patch_errors(const Solution& solution);

/// The root mean square of patch_errors() over all surfaces, over the mean illuminance; 0 in the dark.
double relative_error(const Solution& solution);

}  // namespace aktina
