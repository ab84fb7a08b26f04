// A triangle as the scanners read it: one cache line.
#pragma once

#include <cstdint>

#include "aktina/raster/corner_group.h"

namespace aktina {

/// Edge functions E_k = e + a (x - x0) + b (y - y0) in whole units, x and y counting pixels from the block of the
/// triangle's first pixel: a pixel is covered where all three are >= 0. They are floor(exact / 256) of the exact ones
/// in 1/256 px, less one unit of the exact where the edge is not the triangle's own (top-left rule): exact, then, at
/// all pixel centres.
struct alignas(64) TriangleRecord {
  static constexpr int32_t kLarge = INT32_MIN;  // in e[0]: e does not fit, see edges_at()
  int32_t a[3], b[3], e[3];
  float z0, zx, zy;                           // depth as a plane, from the same block
  uint16_t first_x, first_y, last_x, last_y;  // pixels
  union {
    struct {
      int32_t x, y;
    } corner;  // of a large one: corner 0, 1/256 px
    /// Of others: bits of the 4 x 4 blocks from the origin, row by row, that it may cover; 0 where it reaches beyond.
    uint32_t blocks;
  };

  bool large() const { return e[0] == kLarge; }
  int origin_x() const { return first_x & ~3; }
  int origin_y() const { return first_y & ~3; }
};
static_assert(sizeof(TriangleRecord) == 64);

/// The edge functions of a large triangle at pixel (x, y), whole. @pre  x, y within the picture
struct Edges {
  int64_t e[3];
};
Edges edges_at(const TriangleRecord& record, int x, int y);

/// Barycentric coordinates of corners 1 and 2 on the screen, as planes from the record's origin.
struct ScreenPlanes {
  Lanes constant[2], dx[2], dy[2];
};

/// Sets up a group: kLanes records, of which `group.count` count.
void set_up_triangles(const CornerGroup& group, int width, int height, TriangleRecord* out, ScreenPlanes& planes);

}  // namespace aktina
