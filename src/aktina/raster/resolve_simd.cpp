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

/// Four pixels of a block's row, channels interleaved.
HWY_INLINE void interleave(const RasterBand& band, size_t at, float* to) {
  for (size_t i = 0; i < size_t(kBlock); i += kRowPart)
    hn::StoreInterleaved3(hn::Load(kRow, band.colour[0].data() + at + i),
                          hn::Load(kRow, band.colour[1].data() + at + i),
                          hn::Load(kRow, band.colour[2].data() + at + i), kRow, to + 3 * i);
}

void ResolveColour(const RasterBand& band, Image& out) {
  const BlockLayout& layout = band.visible.layout;
  alignas(64) float four[kBlock * 3];
  for (int y = layout.first_row; y < layout.first_row + layout.rows; ++y) {
    const size_t row = layout.offset(0, y & ~3) + size_t((y & 3) * kBlock);
    float* to = out.at(0, y);
    // The picture is not read again soon: where lines are aligned, it goes past the cache.
    const bool past_cache = reinterpret_cast<uintptr_t>(to) % (kRowPart * sizeof(float)) == 0;
    for (int x = 0; x < out.width; x += kBlock, to += kBlock * 3) {
      interleave(band, row + size_t(x / kBlock) * kLanes, four);
      if (past_cache && x + kBlock <= out.width) {
        for (size_t i = 0; i < size_t(kBlock * 3); i += kRowPart) hn::Stream(hn::Load(kRow, four + i), kRow, to + i);
      } else {
        std::memcpy(to, four, size_t(std::min(kBlock, out.width - x)) * 3 * sizeof(float));
      }
    }
  }
  hwy::FlushStream();
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(ResolveColour);

void resolve_colour(const RasterBand& band, Image& out) { HWY_DYNAMIC_DISPATCH(ResolveColour)(band, out); }

}  // namespace aktina
#endif
