// What passes clear surfaces: of the light that they hide, each lets its transmittance go straight on.
#pragma once

#include "aktina/radiosity/viewfactor/view_factors.h"

namespace aktina {

/// Of each pair's exchange, what clear surfaces hide is known from two matrices: one where they hide all, one where
/// they hide nothing. Rays between the two tell how much of it passes on average: exact where what is hidden goes
/// through one surface, or through as many of one transmittance everywhere.
/// @param scene   with transmittances
/// @param closed  clear surfaces hide all
/// @param open    clear surfaces hide nothing: becomes the result
/// @param target  wanted error of a factor
void let_through(const ViewFactorScene& scene, const ViewFactors& closed, double target, ViewFactors& open,
                 Progress* progress);

}  // namespace aktina
