// What deferred pipelines need per pixel: names at first, then attributes of those that are seen.
#include <hwy/cache_control.h>

#include "aktina/raster/band.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/deferred_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/raster/polynomial_simd.h"
#include "aktina/raster/scan_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

void DrawDeferred(const TriangleChunk& chunk, uint32_t first_name, std::span<const uint32_t> list, RasterBand& band) {
  const BlockLayout layout = band.visible.layout;
  float* const depths = band.visible.depth.data();
  auto* const seen = reinterpret_cast<int32_t*>(band.visible.seen.data());
  for (size_t at_list = 0; at_list < list.size(); ++at_list) {
    const uint32_t n = list[at_list];
    hwy::Prefetch(&chunk.records[list[std::min(at_list + kAhead, list.size() - 1)]]);
    const TriangleRecord& t = chunk.records[n];
    const I name = set(int32_t(first_name + n));
    scan(t, layout, [&](const Block& b) HWY_ATTR {
      const size_t at = b.offset;
      for (size_t p = 0; p < kParts; ++p) {
        const size_t i = at + p * kPart;
        const F z = depth_at(t, b, p), before = load(depths + i);
        const M nearer = hn::And(b.covered_part(p), z > before);
        store(select(nearer, z, before), depths + i);
        store(select(nearer, name, load(seen + i)), seen + i);
      }
    });
  }
}

void VisitNearer(const TriangleRecord& t, const VisibilityBuffer& visible, VisitBlock visit) {
  const BlockLayout layout = visible.layout;
  scan(t, layout, [&](const Block& b) HWY_ATTR {
    Lanes depth;
    uint32_t bits = 0;
    for (size_t p = 0; p < kParts; ++p) {
      const F z = depth_at(t, b, p), before = load(visible.depth.data() + b.offset + p * kPart);
      store(z, depth.v + p * kPart);
      bits |= bits_of(hn::And(b.covered_part(p), z > before)) << (p * kPart);
    }
    if (bits != 0) visit(b.x(), b.y(), bits, depth.v);
  });
}

/// A triangle that is seen in a block: its pixels, its planes, and the block from its origin.
struct Seen {
  uint32_t bits;
  const float* planes;
  float x, y;
};

/// The few different triangles of a block.
HWY_INLINE int find_seen(const RasterFrame& frame, const ShadeBatch& batch, size_t block, Seen (&out)[kLanes]) {
  const auto* names = reinterpret_cast<const int32_t*>(batch.seen) + block * kLanes;
  const auto where = [&](uint32_t name) HWY_ATTR {
    uint32_t bits = 0;
    for (size_t p = 0; p < kParts; ++p)
      bits |= bits_of(mask(load(names + p * kPart) == set(int32_t(name)))) << (p * kPart);
    return bits;
  };
  int count = 0;
  for (uint32_t left = ~where(kNobody) & 0xffffU; left != 0;) {
    const auto name = uint32_t(names[std::countr_zero(left)]);
    const uint32_t bits = where(name);
    left &= ~bits;
    const TriangleRecord& r = frame.record(name);
    out[count++] = {bits, frame.planes(name), float(batch.x[block] - r.origin_x()),
                    float(batch.y[block] - r.origin_y())};
  }
  return count;
}

/// What is plane number `at` of each pixel's triangle.
HWY_INLINE F blend_planes(const Seen* seen, int count, int at, size_t p) {
  F sum = zero();
  for (int n = 0; n < count; ++n) {
    const F x = lane_x(p * kPart) + set(seen[n].x), y = lane_y(p * kPart) + set(seen[n].y);
    sum = select(mask_of(seen[n].bits, p * kPart), plane_at(seen[n].planes + at, x, y), sum);
  }
  return sum;
}

template <int Degree>
HWY_INLINE void interpolate_channels(const PlaneLayout& layout, bool normal, const Seen* seen, int count, F w, size_t p,
                                     float (&out)[kMostChannels][ShadeBatch::kPixels], size_t i) {
  F u = zero(), v = zero();
  if constexpr (Degree >= 2) {
    u = blend_planes(seen, count, layout.screen_at(), p) * w;
    v = blend_planes(seen, count, layout.screen_at() + 3, p) * w;
  }
  for (int c = 0; c < layout.channels; ++c) {
    const int at = layout.channel_at(c);
    F sum = zero();
    for (int n = 0; n < count; ++n) {
      if constexpr (Degree == 1) u = lane_x(p * kPart) + set(seen[n].x), v = lane_y(p * kPart) + set(seen[n].y);
      sum = select(mask_of(seen[n].bits, p * kPart), polynomial_at<Degree>(seen[n].planes + at, u, v), sum);
    }
    if (Degree == 1 && !(normal && c < 3)) sum = sum * w;  // normals may be of any length
    store(sum, out[c] + i);
  }
}

/// World positions of the pixels of a block, from their depth.
HWY_INLINE void find_positions(const View::Pixels& view, int x0, int y0, F depth, size_t p, ShadeBatch& batch,
                               size_t i) {
  const F x = lane_x(p * kPart) + set(float(x0) + 0.5f), y = lane_y(p * kPart) + set(float(y0) + 0.5f);
  const F scale = view.perspective ? set(1.0f) / depth : set(1.0f);
  for (int k = 0; k < 3; ++k) {
    const F across = fma(x, set(view.right[k]), fma(y, set(view.down[k]), set(view.corner[k])));
    const F along = view.perspective ? zero() : depth * set(view.forward[k]);
    store(fma(across, scale, set(view.eye[k])) - along, batch.position[k] + i);
  }
}

template <int Degree>
void interpolate_degree(const RasterFrame& frame, const Pipeline& pipeline, ShadeBatch& batch) {
  const View::Pixels view = frame.view.pixels();
  const PlaneLayout layout = pipeline.layout;
  for (size_t block = 0; block < batch.blocks; ++block) {
    Seen seen[kLanes];
    const int count = find_seen(frame, batch, block, seen);
    for (size_t p = 0; p < kParts; ++p) {
      const size_t i = block * kLanes + p * kPart;
      const auto nobody = load(reinterpret_cast<const int32_t*>(batch.seen) + i) == set(int32_t(-1));
      const F depth = select(mask(nobody), set(1.0f), load(batch.depth + i));
      const F w = view.perspective ? set(1.0f) / depth : set(1.0f);
      find_positions(view, batch.x[block], batch.y[block], depth, p, batch, i);
      const F channel_w = layout.perspective ? w : set(1.0f);
      interpolate_channels<Degree>(layout, pipeline.plan.normal, seen, count, channel_w, p, batch.channel, i);
      if (layout.surface)
        for (int k = 0; k < 2; ++k) store(blend_planes(seen, count, 3 * k, p) * w, batch.surface[k] + i);
    }
  }
}

void Interpolate(const RasterFrame& frame, const Pipeline& pipeline, ShadeBatch& batch) {
  switch (pipeline.layout.degree) {
    case 0:
      return interpolate_degree<0>(frame, pipeline, batch);
    case 1:
      return interpolate_degree<1>(frame, pipeline, batch);
    case 2:
      return interpolate_degree<2>(frame, pipeline, batch);
    default:
      return interpolate_degree<3>(frame, pipeline, batch);
  }
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(DrawDeferred);
HWY_EXPORT(VisitNearer);
HWY_EXPORT(Interpolate);

void draw_deferred(const TriangleChunk& chunk, uint32_t first_name, std::span<const uint32_t> list, RasterBand& band) {
  HWY_DYNAMIC_DISPATCH(DrawDeferred)(chunk, first_name, list, band);
}

void visit_nearer(const TriangleRecord& record, const VisibilityBuffer& visible, VisitBlock visit) {
  HWY_DYNAMIC_DISPATCH(VisitNearer)(record, visible, visit);
}

void interpolate(const RasterFrame& frame, const Pipeline& pipeline, ShadeBatch& batch) {
  HWY_DYNAMIC_DISPATCH(Interpolate)(frame, pipeline, batch);
}

}  // namespace aktina
#endif
