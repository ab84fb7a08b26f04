// Which pixels a triangle covers, in blocks of 4 x 4 pixels: the loop that all back ends inline.
// Included by *_simd.cpp files after "aktina/base/simd.h", once for each instruction set.

#if defined(AKTINA_RASTER_SCAN_SIMD_H_) == defined(HWY_TARGET_TOGGLE)  // per-target include guard
#ifdef AKTINA_RASTER_SCAN_SIMD_H_
#undef AKTINA_RASTER_SCAN_SIMD_H_
#else
#define AKTINA_RASTER_SCAN_SIMD_H_
#endif

#include <algorithm>
#include <bit>

#include "aktina/base/simd.h"
#include "aktina/raster/block_buffer.h"
#include "aktina/raster/triangle_record.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {

/// Columns and rows of the pixels of a block, lane by lane; also those of the blocks of a tile of 4 x 4.
struct alignas(64) LanePlaces {
  float x[16], y[16];
};
inline constexpr LanePlaces kLanePlaces = {{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3},
                                           {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3}};
HWY_INLINE F lane_x(size_t i) { return load(kLanePlaces.x + i); }
HWY_INLINE F lane_y(size_t i) { return load(kLanePlaces.y + i); }

/// Sixteen 32-bit lanes, whatever the width of vectors.
struct Ints {
  I part[kParts];
};

HWY_INLINE Ints step_lanes(int32_t a, int32_t b) {
  Ints out;
  for (size_t p = 0; p < kParts; ++p) {
    const I x = hn::ConvertTo(kInt, lane_x(p * kPart)), y = hn::ConvertTo(kInt, lane_y(p * kPart));
    out.part[p] = set(a) * x + set(b) * y;
  }
  return out;
}

/// Not negative in all three: covered.
HWY_INLINE hn::Mask<IntTag> covered(I e0, I e1, I e2) {
  return hn::Not(hn::Lt(hn::Or(hn::Or(e0, e1), e2), set(int32_t(0))));
}

/// A block of a triangle: where it is, and how to ask which of its pixels are covered.
struct Block {
  int x, y;           // upper left pixel
  const Ints* lanes;  // of the three edges
  int32_t e[3];       // at the upper left pixel

  HWY_INLINE M covered_part(size_t p) const {
    return mask(covered(lanes[0].part[p] + set(e[0]), lanes[1].part[p] + set(e[1]), lanes[2].part[p] + set(e[2])));
  }
};

/// Blocks of a tile of at most 4 x 4 that lie within `columns` x `rows` blocks, bit by bit.
HWY_INLINE uint32_t blocks_within(int columns, int rows) {
  const uint32_t row = columns >= 4 ? 0xfU : (1U << columns) - 1;
  return rows >= 4 ? row * 0x1111U : (row * 0x1111U) & ((1U << (4 * rows)) - 1);
}

/// Calls visit(const Block&) for each block of pixel rows first_row .. last_row (first_row a multiple of 4) in which
/// the triangle may cover pixels.
template <class Visit>
HWY_INLINE void scan(const TriangleRecord& t, int first_row, int last_row, const Visit& visit) {
  const int x0 = t.origin_x(), y0 = std::max(t.origin_y(), first_row);
  const int x1 = t.last_x, y1 = std::min<int>(t.last_y, last_row);
  Ints lanes[3];
  int32_t corner[3];  // from the upper left pixel of a block to where the edge function is largest in it
  for (int k = 0; k < 3; ++k) {
    lanes[k] = step_lanes(t.a[k], t.b[k]);
    corner[k] = 3 * std::max(t.a[k], 0) + 3 * std::max(t.b[k], 0);
  }
  const bool large = t.large();
  for (int tile_y = y0; tile_y <= y1; tile_y += 16)
    for (int tile_x = x0; tile_x <= x1; tile_x += 16) {
      int32_t e[3];
      if (large) {  // within a tile they change by less than 2^30, so what is cut off does not change its sign
        const Edges edges = edges_at(t, tile_x, tile_y);
        for (int k = 0; k < 3; ++k)
          e[k] = int32_t(std::clamp<int64_t>(edges.e[k], -(int64_t(1) << 30), int64_t(1) << 30));
      } else {
        for (int k = 0; k < 3; ++k) e[k] = t.e[k] + t.a[k] * (tile_x - x0) + t.b[k] * (tile_y - t.origin_y());
      }
      uint32_t blocks = 0;
      for (size_t p = 0; p < kParts; ++p) {
        I highest[3];
        for (int k = 0; k < 3; ++k) highest[k] = hn::ShiftLeft<2>(lanes[k].part[p]) + set(e[k] + corner[k]);
        blocks |= bits_of(mask(covered(highest[0], highest[1], highest[2]))) << (p * kPart);
      }
      blocks &= blocks_within(((x1 - tile_x) >> 2) + 1, ((y1 - tile_y) >> 2) + 1);
      for (; blocks != 0; blocks &= blocks - 1) {
        const int i = std::countr_zero(blocks), x = (i & 3) * 4, y = i & 12;
        Block block{tile_x + x, tile_y + y, lanes, {}};
        for (int k = 0; k < 3; ++k) block.e[k] = e[k] + t.a[k] * x + t.b[k] * y;
        visit(block);
      }
    }
}

/// Depth of a triangle at the pixels of a block.
HWY_INLINE F depth_at(const TriangleRecord& t, const Block& b, size_t p) {
  const F x = lane_x(p * kPart) + set(float(b.x - t.origin_x())),
          y = lane_y(p * kPart) + set(float(b.y - t.origin_y()));
  return fma(set(t.zx), x, fma(set(t.zy), y, set(t.z0)));
}

}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
