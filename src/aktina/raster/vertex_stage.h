// Vertices to the screen, many at a time.
#pragma once

#include <vector>

#include "aktina/raster/draw_list.h"
#include "aktina/raster/view.h"

namespace aktina {

/// A vertex of a draw list on the screen. Where it is to be clipped the others say nothing.
struct alignas(16) ScreenPoint {
  int32_t x, y;  // as ScreenVertex
  float depth;   // as ScreenVertex; the weight is it, or 1 in a parallel projection
  /// Bits of the clip planes that the vertex is beyond, as Clipper::outside; above these, of the picture's four sides,
  /// a pixel away from it: no reason to clip, but a triangle with all three vertices beyond one is not seen.
  int32_t outside;
  static constexpr int32_t kClipPlanes = 63;
  bool to_be_clipped() const { return outside & kClipPlanes; }
};

/// Padded to whole groups of kLanes.
class ScreenVertices {
 public:
  void resize(size_t n) { points_.resize(padded(n)); }
  const ScreenPoint& operator[](size_t i) const { return points_[i]; }
  /// As numbers of four bytes each.
  float* data() { return reinterpret_cast<float*>(points_.data()); }
  const float* data() const { return reinterpret_cast<const float*>(points_.data()); }

 private:
  std::vector<ScreenPoint> points_;
};

/// Vertices begin .. end - 1; begin is a multiple of kLanes, and whole lines are written.
void project_vertices(const DrawList& list, const View& view, size_t begin, size_t end, ScreenVertices& out);

}  // namespace aktina
