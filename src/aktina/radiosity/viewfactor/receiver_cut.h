// Receivers that blockers stand on or reach through: what is seen jumps along the lines where they meet.
#pragma once

#include "aktina/radiosity/viewfactor/blockers.h"

namespace aktina {

/// Cuts the convex pieces of a receiver along the plane of each face of the blocker that meets it, so that each piece
/// is on one side. Adds nothing where there are many pieces already.
void cut_where_met(const Blocker& blocker, const Plane& receiver, double tolerance, std::vector<Contour>& pieces);

}  // namespace aktina
