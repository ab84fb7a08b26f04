// Triangles that are seen, sixteen at a time: culled, clipped, and turned so that edge functions are positive inside.
#pragma once

#include "aktina/base/function_ref.h"
#include "aktina/raster/shading/shading_method.h"
#include "aktina/raster/vertex_stage.h"

namespace aktina {

/// Lanes from `count` on hold copies of the last valid one.
struct CornerGroup {
  int count = 0;
  LanesOf<int32_t> x[3], y[3];  // of corner k, as ScreenVertex
  Lanes depth[3];               // as ScreenVertex
  LanesOf<uint32_t> vertex[3];  // of the draw list. Of clipped triangles: the original's
  LanesOf<uint32_t> triangle;   // of the draw list
  Lanes side;                   // 1: front; -1: back, whose corners 1 and 2 have changed places
  bool clipped = false;         // corners are not the vertices, but between them:
  Lanes barycentric[3][3];      // [corner][vertex], on the surface
};

struct TriangleRange {
  uint32_t begin, end;
};

/// Calls `emit` with groups of the triangles begin .. end - 1 of a draw list that cover a pixel centre's rectangle in
/// the picture, in their order. @param cull  leaves out the backs
void gather_triangles(const DrawList& list, const ScreenVertices& screen, const View& view, TriangleRange range,
                      bool cull, FunctionRef<void(const CornerGroup&)> emit);

}  // namespace aktina
