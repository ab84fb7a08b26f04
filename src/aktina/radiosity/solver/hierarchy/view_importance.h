// What of a scene matters to one picture: directly seen importance.
//
// B. Smits, J. Arvo, D. Salesin, "An Importance-Driven Radiosity Algorithm", SIGGRAPH '92.
#pragma once

#include <vector>

#include "aktina/radiosity/solver/receiver_surfaces.h"
#include "aktina/scene/camera.h"

namespace aktina {

/// By receiver: the share of the picture that a square metre of it takes up, m^-2. The sum over receivers of this times
/// their area is 1 where the picture shows nothing else. By 16 places and shadow rays a piece.
/// @param view  a picture of 3 : 2 where its aspect is left open
std::vector<double> view_importance(const SurfaceLayout& layout, size_t receivers, const Visibility& visibility,
                                    const Camera& view, uint32_t seed);

}  // namespace aktina
