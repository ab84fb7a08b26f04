#include <array>
#include <bit>
#include <cstring>

#include "aktina/raster/clipped_triangles.h"
#include "aktina/raster/corner_group.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/gather_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/raster/exact_simd.h"
#include "aktina/raster/rows_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

/// kPart triangles in a row of the draw list, as the vertices lie on the screen.
struct Loaded {
  I x[3], y[3], vertex[3], outside[3];
  F depth[3];
};

HWY_INLINE Loaded load_triangles(const DrawList& list, const ScreenVertices& screen, uint32_t first) {
  Loaded t;
  for (int k = 0; k < 3; ++k) {
    const uint32_t* index = list.index(k) + first;
    F columns[4];
    load_rows([&](size_t i) { return screen.data() + 4 * size_t(index[i]); }, columns);
    t.x[k] = bits_of(columns[0]), t.y[k] = bits_of(columns[1]);
    t.depth[k] = columns[2], t.outside[k] = bits_of(columns[3]);
    t.vertex[k] = hn::LoadU(kInt, reinterpret_cast<const int32_t*>(index));
  }
  return t;
}

/// What is known of triangles before any is set up, one bit each.
struct Verdict {
  uint32_t seen;     // drawn as they are
  uint32_t crosses;  // to be clipped
  uint32_t back;
};

HWY_INLINE uint32_t meets_pixels(const I (&v)[3], int size) {  // pixel_range()
  const I smallest = hn::Min(hn::Min(v[0], v[1]), v[2]), largest = hn::Max(hn::Max(v[0], v[1]), v[2]);
  const I low = hn::ShiftRight<8>(smallest + set(kSubpixels / 2 - 1));
  const I high = hn::ShiftRight<8>(largest - set(kSubpixels / 2));
  return bits_of(mask(hn::Not(hn::Gt(hn::Max(low, set(int32_t(0))), hn::Min(high, set(size - 1))))));
}

/// Bits of the triangles whose corners run clockwise, y running down, and of those that run the other way.
HWY_INLINE void turn_of(const I (&x)[3], const I (&y)[3], uint32_t& front, uint32_t& back) {
  const I ax = x[1] - x[0], ay = y[1] - y[0], bx = x[2] - x[0], by = y[2] - y[0];
  const auto half = [&](auto part, size_t shift) HWY_ATTR {
    const D area = wide(part(ax)) * wide(part(by)) - wide(part(bx)) * wide(part(ay));
    front |= narrow_bits(kDouble, area < wide(0.0)) << shift, back |= narrow_bits(kDouble, area > wide(0.0)) << shift;
  };
#if HWY_TARGET == HWY_SCALAR
  half([](I v) { return v; }, 0);
#else
  static_assert(2 * kWidePart == kPart);
  half([](I v) HWY_ATTR { return hn::LowerHalf(kNarrowInt, v); }, 0);
  half([](I v) HWY_ATTR { return hn::UpperHalf(kNarrowInt, v); }, kWidePart);
#endif
}

HWY_INLINE Verdict judge(const Loaded& t, const View& view) {
  const I none = set(int32_t(0));
  const uint32_t hidden = bits_of(mask(hn::Ne(t.outside[0] & t.outside[1] & t.outside[2], none)));
  const I beyond = (t.outside[0] | t.outside[1] | t.outside[2]) & set(ScreenPoint::kClipPlanes);
  const uint32_t crosses = bits_of(mask(hn::Ne(beyond, none))) & ~hidden;
  uint32_t front = 0, back = 0;
  turn_of(t.x, t.y, front, back);
  const uint32_t meets = meets_pixels(t.x, view.width()) & meets_pixels(t.y, view.height());
  return {meets & (front | back) & ~hidden & ~crosses, crosses, back};
}

/// Triangles that wait until sixteen are there.
class Queue {
 public:
  explicit Queue(FunctionRef<void(const CornerGroup&)> emit) : emit_(emit) {}

  /// Those of kPart triangles whose bit is set in `seen`.
  HWY_INLINE void push(const Loaded& t, uint32_t first, uint32_t seen, uint32_t back) {
    const M chosen = mask_of(seen, 0), turned = mask_of(back, 0);
    for (int k = 0; k < 3; ++k) {
      const int other = (3 - k) % 3;  // corners 1 and 2 of a back change places
      put(select(turned, t.x[other], t.x[k]), chosen, x_[k]);
      put(select(turned, t.y[other], t.y[k]), chosen, y_[k]);
      put(bits_of(select(turned, t.depth[other], t.depth[k])), chosen, depth_[k]);
      put(select(turned, t.vertex[other], t.vertex[k]), chosen, vertex_[k]);
    }
    put(hn::Iota(kInt, int32_t(first)), chosen, triangle_);
    put(bits_of(select(turned, set(-1.0f), set(1.0f))), chosen, side_);
    count_ += size_t(std::popcount(seen));
    if (count_ >= kLanes) emit_full();
  }

  void flush() {
    if (count_ == 0) return;
    for (size_t i = count_; i < kLanes; ++i)
      for (Column* column : columns()) column->v[i] = column->v[count_ - 1];
    emit(int(count_));
    count_ = 0;
  }

 private:
  struct alignas(64) Column {
    int32_t v[2 * kLanes];
  };

  HWY_INLINE void put(I v, M chosen, Column& to) const {
    hn::StoreU(hn::Compress(v, int_mask(chosen)), kInt, to.v + count_);
  }
  std::array<Column*, 14> columns() {
    return {&x_[0],     &x_[1],     &x_[2],      &y_[0],      &y_[1],      &y_[2],     &depth_[0],
            &depth_[1], &depth_[2], &vertex_[0], &vertex_[1], &vertex_[2], &triangle_, &side_};
  }

  void emit_full() {
    emit(int(kLanes));
    count_ -= kLanes;
    for (Column* column : columns())
      for (size_t i = 0; i < kLanes; i += kPart) store(load(column->v + kLanes + i), column->v + i);
  }

  void emit(int count) {
    CornerGroup g;
    g.count = count;
    const auto copy = [](const Column& from, auto& to) { std::memcpy(to.v, from.v, sizeof to.v); };
    for (int k = 0; k < 3; ++k) {
      copy(x_[k], g.x[k]), copy(y_[k], g.y[k]), copy(depth_[k], g.depth[k]), copy(vertex_[k], g.vertex[k]);
    }
    copy(triangle_, g.triangle), copy(side_, g.side);
    emit_(g);
  }

  FunctionRef<void(const CornerGroup&)> emit_;
  size_t count_ = 0;
  Column x_[3], y_[3], depth_[3], vertex_[3], triangle_, side_;
};

void GatherTriangles(const DrawList& list, const ScreenVertices& screen, const View& view, TriangleRange range,
                     bool cull, FunctionRef<void(const CornerGroup&)> emit) {
  Queue queue(emit);
  ClippedTriangles clipped(list, screen, view, cull);
  for (uint32_t first = range.begin; first < range.end; first += kPart) {
    const uint32_t left = range.end - first;
    const uint32_t valid = left >= kPart ? (1U << kPart) - 1 : (1U << left) - 1;
    const Loaded triangles = load_triangles(list, screen, first);
    const Verdict verdict = judge(triangles, view);
    uint32_t seen = verdict.seen & valid;
    if (cull) seen &= ~verdict.back;
    const uint32_t crosses = verdict.crosses & valid;
    if (crosses != 0) {  // in their order, whole ones too
      queue.flush();
      clipped.draw(first, seen | crosses, emit);
    } else if (seen != 0) {
      queue.push(triangles, first, seen, verdict.back);
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
