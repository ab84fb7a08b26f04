// Vertices to the screen, many at a time.
#pragma once

#include "aktina/raster/draw_list.h"
#include "aktina/raster/view.h"

namespace aktina {

/// One value a vertex of a draw list. Where `outside` is not 0 the others say nothing.
struct ScreenVertices {
  LineArray<int32_t> x, y;     // as ScreenVertex
  LineArray<float> depth;      // as ScreenVertex; the weight is it, or 1 in a parallel projection
  LineArray<int32_t> outside;  // bits of the clip planes that the vertex is beyond, as Clipper::outside

  void resize(size_t n) { x.resize(n), y.resize(n), depth.resize(n), outside.resize(n); }
};

/// Vertices begin .. end - 1; begin is a multiple of kLanes, and whole lines are written.
void project_vertices(const DrawList& list, const View& view, size_t begin, size_t end, ScreenVertices& out);

}  // namespace aktina
