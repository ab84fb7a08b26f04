// What a shading method reads of sixteen triangles.
#pragma once

#include "aktina/raster/raster_frame.h"

namespace aktina {

/// Fills the members of `out` that `pipeline.plan.needs` names.
void fill_group(const RasterFrame& frame, const Pipeline& pipeline, const CornerGroup& corners, TriangleGroup& out);

}  // namespace aktina
