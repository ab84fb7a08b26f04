// Where pixels stand in the rasterizer's own buffers: blocks of 4 x 4, row by row; a block is one cache line.
#pragma once

#include <algorithm>

#include "aktina/raster/line_array.h"

namespace aktina {

inline constexpr int kBlock = 4;                 // px
inline constexpr uint32_t kNobody = 0xffffffff;  // the triangle of a pixel that sees none

/// Sizes of a buffer that covers rows first_row .. first_row + rows - 1 of a picture. Both sides are padded to whole
/// tiles of 16 x 4, which scanning may write to.
struct BlockLayout {
  int first_row = 0, rows = 0, width = 0;
  int blocks_across() const { return (width + 15) / 16 * 4; }
  int blocks_down() const { return (rows + kBlock - 1) / kBlock; }
  size_t blocks() const { return size_t(blocks_across()) * size_t(blocks_down()); }
  /// Of the first value of the block at pixel (x, y), both multiples of 4.
  size_t offset(int x, int y) const {
    return (size_t((y - first_row) / kBlock) * size_t(blocks_across()) + size_t(x / kBlock)) * kLanes;
  }
  size_t offset_of_pixel(int x, int y) const { return offset(x & ~3, y & ~3) + size_t((y & 3) * kBlock + (x & 3)); }
};

}  // namespace aktina
