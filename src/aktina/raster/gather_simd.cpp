#include <bit>

#include "aktina/raster/clipped_triangles.h"
#include "aktina/raster/corner_group.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/gather_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/raster/exact_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

HWY_INLINE I load(const uint32_t* p) { return hn::LoadU(kInt, reinterpret_cast<const int32_t*>(p)); }
HWY_INLINE I gather(const int32_t* p, I i) { return hn::GatherIndex(kInt, p, i); }
HWY_INLINE F gather(const float* p, I i) { return hn::GatherIndex(kFloat, p, i); }

/// What is known of kWidePart triangles before any is set up, one bit each.
struct Verdict {
  uint32_t seen;     // drawn as they are
  uint32_t crosses;  // to be clipped
  uint32_t back;
};

HWY_INLINE uint32_t meets_pixels(const NI (&v)[3], int size) {  // pixel_range()
  const NI smallest = hn::Min(hn::Min(v[0], v[1]), v[2]), largest = hn::Max(hn::Max(v[0], v[1]), v[2]);
  const NI low = hn::ShiftRight<8>(smallest + narrow_set(kSubpixels / 2 - 1));
  const NI high = hn::ShiftRight<8>(largest - narrow_set(kSubpixels / 2));
  const NM none = hn::Gt(hn::Max(low, narrow_set(0)), hn::Min(high, narrow_set(size - 1)));
  return ~narrow_bits(kNarrowInt, none);
}

HWY_INLINE Verdict judge(const DrawList& list, const ScreenVertices& screen, const View& view, uint32_t first) {
  NI x[3], y[3], outside[3];
  for (int k = 0; k < 3; ++k) {
    const NI v = narrow_load(list.index(k) + first);
    x[k] = hn::GatherIndex(kNarrowInt, screen.x.data(), v), y[k] = hn::GatherIndex(kNarrowInt, screen.y.data(), v);
    outside[k] = hn::GatherIndex(kNarrowInt, screen.outside.data(), v);
  }
  const NI none = narrow_set(0);
  const uint32_t hidden = narrow_bits(kNarrowInt, hn::Ne(outside[0] & outside[1] & outside[2], none));
  const uint32_t crosses = narrow_bits(kNarrowInt, hn::Ne(outside[0] | outside[1] | outside[2], none)) & ~hidden;
  const D area = wide(x[1] - x[0]) * wide(y[2] - y[0]) - wide(x[2] - x[0]) * wide(y[1] - y[0]);  // y runs down
  const uint32_t front = narrow_bits(kDouble, area < wide(0.0)), back = narrow_bits(kDouble, area > wide(0.0));
  const uint32_t meets = meets_pixels(x, view.width()) & meets_pixels(y, view.height());
  return {meets & (front | back) & ~hidden & ~crosses, crosses, back};
}

/// Triangles that wait until sixteen are there.
class Queue {
 public:
  Queue(const DrawList& list, const ScreenVertices& screen, FunctionRef<void(const CornerGroup&)> emit)
      : list_(list), screen_(screen), emit_(emit) {}

  HWY_INLINE void push(uint32_t triangle, bool back) {
    waiting_[count_] = triangle, side_[count_] = back ? -1.0f : 1.0f;
    if (++count_ == kLanes) flush();
  }

  void flush() {
    if (count_ == 0) return;
    for (size_t i = count_; i < kLanes; ++i) waiting_[i] = waiting_[count_ - 1], side_[i] = side_[count_ - 1];
    CornerGroup g;
    g.count = int(count_);
    count_ = 0;
    for (size_t i = 0; i < kLanes; i += kPart) {
      const I triangle = load(waiting_ + i);
      const F side = hn::LoadU(kFloat, side_ + i);
      const M front = side > zero();
      I v[3];
      for (int k = 0; k < 3; ++k)
        v[k] = hn::GatherIndex(kInt, reinterpret_cast<const int32_t*>(list_.index(k)), triangle);
      const I corner[3] = {v[0], select(front, v[1], v[2]), select(front, v[2], v[1])};
      for (int k = 0; k < 3; ++k) {
        store(gather(screen_.x.data(), corner[k]), g.x[k].v + i);
        store(gather(screen_.y.data(), corner[k]), g.y[k].v + i);
        store(gather(screen_.depth.data(), corner[k]), g.depth[k].v + i);
        store(corner[k], reinterpret_cast<int32_t*>(g.vertex[k].v + i));
      }
      store(triangle, reinterpret_cast<int32_t*>(g.triangle.v + i));
      store(side, g.side.v + i);
    }
    emit_(g);
  }

 private:
  const DrawList& list_;
  const ScreenVertices& screen_;
  FunctionRef<void(const CornerGroup&)> emit_;
  size_t count_ = 0;
  uint32_t waiting_[kLanes];
  float side_[kLanes];
};

void GatherTriangles(const DrawList& list, const ScreenVertices& screen, const View& view, TriangleRange range,
                     bool cull, FunctionRef<void(const CornerGroup&)> emit) {
  Queue queue(list, screen, emit);
  ClippedTriangles clipped(list, screen, view, cull);
  for (uint32_t first = range.begin; first < range.end; first += kWidePart) {
    const uint32_t left = range.end - first;
    const uint32_t valid = left >= kWidePart ? (1U << kWidePart) - 1 : (1U << left) - 1;
    const Verdict verdict = judge(list, screen, view, first);
    uint32_t seen = verdict.seen & valid;
    if (cull) seen &= ~verdict.back;
    const uint32_t crosses = verdict.crosses & valid;
    if (crosses != 0) {  // in their order, whole ones too
      queue.flush();
      clipped.draw(first, seen | crosses, emit);
      continue;
    }
    for (; seen != 0; seen &= seen - 1) {
      const int i = std::countr_zero(seen);
      queue.push(first + uint32_t(i), verdict.back >> i & 1);
    }
  }
  queue.flush();
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(GatherTriangles);

void gather_triangles(const DrawList& list, const ScreenVertices& screen, const View& view, TriangleRange range,
                      bool cull, FunctionRef<void(const CornerGroup&)> emit) {
  HWY_DYNAMIC_DISPATCH(GatherTriangles)(list, screen, view, range, cull, emit);
}

}  // namespace aktina
#endif
