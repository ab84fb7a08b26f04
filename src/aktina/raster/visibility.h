// Who is seen at each pixel: depth and triangle, without any light.
#pragma once

#include "aktina/raster/block_buffer.h"
#include "aktina/raster/triangle_record.h"

namespace aktina {

struct VisibilityBuffer {
  BlockLayout layout;
  LineArray<float> depth;
  LineArray<uint32_t> seen;

  /// Nothing is seen, at depth `farthest`. @param names  else `seen` stays as it is
  void clear(const BlockLayout& layout, float farthest, bool names = true);
};

/// Writes triangle name[i] where it is nearer than what was there.
void draw_visibility(const TriangleRecord* records, const uint32_t* names, int count, VisibilityBuffer& out);

}  // namespace aktina
