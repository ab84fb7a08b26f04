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

inline constexpr size_t kAhead = 4;  // triangles whose records are fetched before they are scanned

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

/// Columns (rows) of the pixels of a tile's blocks, from the tile's own: one line for each column (row) of blocks.
struct alignas(64) TilePlaces {
  float x[4][16], y[4][16];
};
constexpr TilePlaces tile_places() {
  TilePlaces t{};
  for (int block = 0; block < 4; ++block)
    for (int i = 0; i < 16; ++i) {
      const int column = i % 4, row = i / 4;
      t.x[block][i] = float(4 * block + column);
      t.y[block][i] = float(4 * block + row);
    }
  return t;
}
inline constexpr TilePlaces kTilePlaces = tile_places();

/// A block of a triangle: where it is, and how to ask which of its pixels are covered.
struct Block {
  int tile_x, tile_y;    // upper left pixel of its tile
  int number;            // in the tile, row by row
  size_t offset;         // of its first value in buffers
  const Ints* lanes;     // of the three edges
  int32_t e[3];          // at its upper left pixel
  float from_x, from_y;  // from the triangle's origin to the tile
  bool small;            // the triangle has one tile, whose origin is its own: known when the program is compiled

  HWY_INLINE int x() const { return tile_x + (number & 3) * kBlock; }
  HWY_INLINE int y() const { return tile_y + (number & 12); }
  HWY_INLINE M covered_part(size_t p) const {
    return mask(covered(lanes[0].part[p] + set(e[0]), lanes[1].part[p] + set(e[1]), lanes[2].part[p] + set(e[2])));
  }
  /// Pixels from the triangle's origin.
  HWY_INLINE F dx(size_t p) const {
    const F x = load(kTilePlaces.x[number & 3] + p * kPart);
    return small ? x : x + set(from_x);
  }
  HWY_INLINE F dy(size_t p) const {
    const F y = load(kTilePlaces.y[number >> 2] + p * kPart);
    return small ? y : y + set(from_y);
  }
};

/// Blocks of a tile of at most 4 x 4 that lie within `columns` x `rows` blocks, bit by bit.
HWY_INLINE uint32_t blocks_within(int columns, int rows) {
  const uint32_t row = columns >= 4 ? 0xfU : (1U << columns) - 1;
  return rows >= 4 ? row * 0x1111U : (row * 0x1111U) & ((1U << (4 * rows)) - 1);
}

/// The three edge functions at the upper left pixel of a tile.
struct TileEdges {
  int32_t e[3];
};
HWY_INLINE TileEdges edges_at_tile(const TriangleRecord& t, int x, int y) {
  TileEdges out;
  if (t.large()) {  // within a tile they change by less than 2^30, so what is cut off does not change their sign
    const Edges edges = edges_at(t, x, y);
    for (int k = 0; k < 3; ++k)
      out.e[k] = int32_t(std::clamp<int64_t>(edges.e[k], -(int64_t(1) << 30), int64_t(1) << 30));
  } else {
    for (int k = 0; k < 3; ++k) out.e[k] = t.e[k] + t.a[k] * (x - t.origin_x()) + t.b[k] * (y - t.origin_y());
  }
  return out;
}

/// The three edge functions at the upper left pixels of a tile's blocks.
struct BlockEdges {
  alignas(64) int32_t e[3][16];
};

/// What stays the same from tile to tile of a triangle.
struct Steps {
  Ints lanes[3];
  HWY_INLINE explicit Steps(const TriangleRecord& t) {
    for (int k = 0; k < 3; ++k) lanes[k] = step_lanes(t.a[k], t.b[k]);
  }
  HWY_INLINE void find_edges(const int32_t (&tile)[3], BlockEdges& out) const {
    for (int k = 0; k < 3; ++k)
      for (size_t p = 0; p < kParts; ++p)
        store(hn::ShiftLeft<2>(lanes[k].part[p]) + set(tile[k]), out.e[k] + p * kPart);
  }
};

/// From the upper left pixel of a block to where an edge function is largest in it.
struct Rises {
  int32_t of_edge[3];
  HWY_INLINE explicit Rises(const TriangleRecord& t) {
    for (int k = 0; k < 3; ++k) of_edge[k] = 3 * std::max(t.a[k], 0) + 3 * std::max(t.b[k], 0);
  }
};

/// Bits of the blocks of a tile that may be covered: where no edge function is negative all over.
HWY_INLINE uint32_t touched_blocks(const Steps& steps, const int32_t (&tile)[3], const Rises& rises) {
  uint32_t blocks = 0;
  for (size_t p = 0; p < kParts; ++p) {
    I highest[3];
    for (int k = 0; k < 3; ++k)
      highest[k] = hn::ShiftLeft<2>(steps.lanes[k].part[p]) + set(tile[k]) + set(rises.of_edge[k]);
    blocks |= bits_of(mask(covered(highest[0], highest[1], highest[2]))) << (p * kPart);
  }
  return blocks;
}

/// Calls visit(const Block&) for the blocks of a tile whose bits are set. @param offset  of the tile's first block;
/// row: from one row of blocks to the next
template <class Visit>
HWY_INLINE void visit_blocks(uint32_t blocks, int tile_x, int tile_y, size_t offset, size_t row, const Steps& steps,
                             const BlockEdges& edges, float from_x, float from_y, bool small, const Visit& visit) {
  for (; blocks != 0; blocks &= blocks - 1) {
    const int i = std::countr_zero(blocks);
    visit(Block{tile_x,
                tile_y,
                i,
                offset + size_t(i >> 2) * row + size_t(i & 3) * kLanes,
                steps.lanes,
                {edges.e[0][i], edges.e[1][i], edges.e[2][i]},
                from_x,
                from_y,
                small});
  }
}

/// A triangle of one tile, whose blocks are known; most are.
template <class Visit>
HWY_INLINE void scan_small(const TriangleRecord& t, const BlockLayout& layout, const Visit& visit) {
  const int before = layout.first_row - t.origin_y(), after = layout.first_row + layout.rows - t.origin_y();  // rows
  if (before >= 16 || after <= 0) return;  // none of its rows are there
  uint32_t blocks = t.blocks;
  if (before > 0) blocks &= ~0U << before;  // four blocks for four rows
  if (after < 16) blocks &= ~(~0U << ((after + 3) & ~3));
  const Steps steps(t);
  BlockEdges edges;
  steps.find_edges(t.e, edges);
  visit_blocks(blocks, t.origin_x(), t.origin_y(), layout.offset(t.origin_x(), t.origin_y()),
               size_t(layout.blocks_across()) * kLanes, steps, edges, 0, 0, true, visit);
}

/// Calls visit(const Block&) for each block of the layout in which the triangle may cover pixels.
template <class Visit>
HWY_INLINE void scan(const TriangleRecord& t, const BlockLayout& layout, const Visit& visit) {
  if (!t.large() && t.blocks != 0) return scan_small(t, layout, visit);
  const int x0 = t.origin_x(), y0 = std::max(t.origin_y(), layout.first_row);
  const int x1 = t.last_x, y1 = std::min<int>(t.last_y, layout.first_row + layout.rows - 1);
  const size_t row = size_t(layout.blocks_across()) * kLanes;
  const Steps steps(t);
  const Rises rises(t);
  BlockEdges edges;
  for (int tile_y = y0; tile_y <= y1; tile_y += 16)
    for (int tile_x = x0; tile_x <= x1; tile_x += 16) {
      const TileEdges tile = edges_at_tile(t, tile_x, tile_y);
      steps.find_edges(tile.e, edges);
      const uint32_t blocks =
          touched_blocks(steps, tile.e, rises) & blocks_within(((x1 - tile_x) >> 2) + 1, ((y1 - tile_y) >> 2) + 1);
      visit_blocks(blocks, tile_x, tile_y, layout.offset(tile_x, tile_y), row, steps, edges, float(tile_x - x0),
                   float(tile_y - t.origin_y()), false, visit);
    }
}

/// Depth of a triangle at the pixels of a block.
HWY_INLINE F depth_at(const TriangleRecord& t, const Block& b, size_t p) {
  return fma(set(t.zx), b.dx(p), fma(set(t.zy), b.dy(p), set(t.z0)));
}

}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
