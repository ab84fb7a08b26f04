// Triangles that cross a clip plane: the slow path beside gather_triangles.
#pragma once

#include "aktina/raster/clip.h"
#include "aktina/raster/corner_group.h"

namespace aktina {

class ClippedTriangles {
 public:
  using Emit = FunctionRef<void(const CornerGroup&)>;
  ClippedTriangles(const DrawList& list, const ScreenVertices& screen, const View& view, bool cull)
      : list_(list), screen_(screen), view_(view), clipper_(view), cull_(cull) {
    group_.clipped = true;
  }

  /// Emits groups of what is left of triangles first + i, for each bit i of `lanes`, in their order.
  void draw(uint32_t first, uint32_t lanes, Emit emit);

 private:
  void cut(uint32_t triangle, Emit emit);
  void add(uint32_t triangle, const std::array<const ClipVertex*, 3>& corners, Emit emit);
  void flush(Emit emit);
  ScreenVertex place(uint32_t triangle, const ClipVertex& corner) const;

  const DrawList& list_;
  const ScreenVertices& screen_;
  const View& view_;
  Clipper clipper_;
  bool cull_;
  CornerGroup group_;
};

}  // namespace aktina
