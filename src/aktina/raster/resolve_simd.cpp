#include <algorithm>
#include <cstring>

#include "aktina/raster/resolve.h"

#include <hwy/cache_control.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/resolve_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/base/simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

using RowTag = hn::CappedTag<float, 4>;
constexpr RowTag kRow;
constexpr size_t kRowPart = hn::MaxLanes(RowTag());

constexpr int kColumns = 128;  // of a strip

/// Columns and four rows of a picture: blocks, pixel by pixel. Long enough that few lines of the picture are written in
/// two parts, short enough for the cache.
struct alignas(64) Strip {
  float v[kColumns / kBlock][kLanes * 3];
};

/// A block with its channels interleaved.
HWY_INLINE void interleave(const RasterBand& band, float farthest, const F (&background)[3], size_t at, float* to) {
  for (size_t i = 0; i < kLanes; i += kPart) {
    const M unseen = load(band.visible.depth.data() + at + i) == set(farthest);
    F c[3] = {background[0], background[1], background[2]};
    if (band.filled || !hn::AllTrue(kFloat, unseen))
      for (int k = 0; k < 3; ++k) {
        const F colour = load(band.colour[k].data() + at + i);
        c[k] = band.filled ? colour : select(unseen, c[k], colour);
      }
    hn::StoreInterleaved3(c[0], c[1], c[2], kFloat, to + 3 * i);
  }
}

/// The part of a strip's row that lies within the picture. @param columns  of it
HWY_INLINE void copy_row(const Strip& strip, int row, int columns, float* to) {
  // The picture is not read again soon: where it is aligned, it goes past the cache.
  const bool past_cache = reinterpret_cast<uintptr_t>(to) % (kRowPart * sizeof(float)) == 0;
  for (int block = 0; block * kBlock < columns; ++block, to += kBlock * 3) {
    const float* from = strip.v[block] + row * kBlock * 3;
    if (past_cache && (block + 1) * kBlock <= columns) {
      for (size_t i = 0; i < size_t(kBlock * 3); i += kRowPart) hn::Stream(hn::Load(kRow, from + i), kRow, to + i);
    } else {
      std::memcpy(to, from, size_t(std::min(kBlock, columns - block * kBlock)) * 3 * sizeof(float));
    }
  }
}

void ResolveColour(const RasterBand& band, const View& view, Rgb background, Image& out) {
  const BlockLayout& layout = band.visible.layout;
  const F behind[3] = {set(background.r), set(background.g), set(background.b)};
  Strip strip;
  for (int y = 0; y < layout.rows; y += kBlock)
    for (int x = 0; x < out.width; x += kColumns) {
      const int columns = std::min(kColumns, out.width - x);
      const size_t at = layout.offset(x, layout.first_row + y);
      for (int block = 0; block * kBlock < columns; ++block)
        interleave(band, view.farthest(), behind, at + size_t(block) * kLanes, strip.v[block]);
      for (int row = 0; row < std::min(kBlock, layout.rows - y); ++row)
        copy_row(strip, row, columns, out.at(x, layout.first_row + y + row));
    }
  hwy::FlushStream();
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(ResolveColour);

void resolve_colour(const RasterBand& band, const View& view, Rgb background, Image& out) {
  HWY_DYNAMIC_DISPATCH(ResolveColour)(band, view, background, out);
}

}  // namespace aktina
#endif
