#include "aktina/raster/visibility.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/visibility_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/raster/scan_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

void DrawVisibility(const TriangleRecord* records, const uint32_t* names, int count, VisibilityBuffer& out) {
  const BlockLayout layout = out.layout;
  for (int n = 0; n < count; ++n) {
    const TriangleRecord& t = records[n];
    const I name = set(int32_t(names[n]));
    scan(t, layout, [&](const Block& b) HWY_ATTR {
      const size_t at = b.offset;
      for (size_t p = 0; p < kParts; ++p) {
        float* depth = out.depth.data() + at + p * kPart;
        auto* seen = reinterpret_cast<int32_t*>(out.seen.data()) + at + p * kPart;
        const F z = depth_at(t, b, p), before = load(depth);
        const M nearer = hn::And(b.covered_part(p), z > before);
        store(select(nearer, z, before), depth);
        store(select(nearer, name, load(seen)), seen);
      }
    });
  }
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(DrawVisibility);

void VisibilityBuffer::clear(const BlockLayout& new_layout, float farthest, bool names) {
  layout = new_layout;
  const size_t size = layout.blocks() * kLanes;
  depth.resize(size), seen.resize(size);
  std::fill_n(depth.data(), size, farthest);
  if (names) std::fill_n(seen.data(), size, kNobody);
}

void draw_visibility(const TriangleRecord* records, const uint32_t* names, int count, VisibilityBuffer& out) {
  HWY_DYNAMIC_DISPATCH(DrawVisibility)(records, names, count, out);
}

}  // namespace aktina
#endif
