// Edge functions and depth planes, sixteen triangles at a time.
//
// J. Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988.
#include <cstddef>

#include "aktina/raster/triangle_record.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/triangle_setup_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/raster/exact_simd.h"
#include "aktina/raster/rows_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

/// kWidePart triangles in registers, their edges, and the pixels they can reach.
struct Triangles {
  NI x[3], y[3], a[3], b[3], e[3];
  NI first_x, first_y, last_x, last_y, origin_x, origin_y;
  NM large;
  D exact[3];  // edge functions at the centre of the origin, 1/256 px squared
  NF depth[3];
};

constexpr int32_t kLargest = 1 << 17;  // 1/256 px between corners, for edge functions that fit 32 bits all over

HWY_INLINE void find_pixels(Triangles& t, int width, int height) {
  const auto range = [](const NI(&v)[3], int size, NI& first, NI& last) HWY_ATTR {  // pixel_range()
    const NI low = hn::Min(hn::Min(v[0], v[1]), v[2]), high = hn::Max(hn::Max(v[0], v[1]), v[2]);
    first = hn::Max(hn::ShiftRight<8>(low + narrow_set(kSubpixels / 2 - 1)), narrow_set(0));
    last = hn::Min(hn::ShiftRight<8>(high - narrow_set(kSubpixels / 2)), narrow_set(size - 1));
    return high - low;
  };
  const NI across = range(t.x, width, t.first_x, t.last_x), down = range(t.y, height, t.first_y, t.last_y);
  t.large = hn::Gt(hn::Max(across, down), narrow_set(kLargest));
  t.origin_x = t.first_x & narrow_set(~3), t.origin_y = t.first_y & narrow_set(~3);
}

/// Edge k lies opposite corner k. The top-left rule: an edge has the pixels upon it where it leads upwards on the left,
/// or is horizontal and on top.
HWY_INLINE void find_edges(Triangles& t) {
  const NI none = narrow_set(0);
  const NI centre_x = hn::ShiftLeft<8>(t.origin_x) + narrow_set(kSubpixels / 2);
  const NI centre_y = hn::ShiftLeft<8>(t.origin_y) + narrow_set(kSubpixels / 2);
  for (int k = 0; k < 3; ++k) {
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    const NI a = t.y[to] - t.y[from], b = t.x[from] - t.x[to];
    t.a[k] = a, t.b[k] = b;
    t.exact[k] = wide(a) * wide(centre_x - t.x[from]) + wide(b) * wide(centre_y - t.y[from]);
    const NM own = hn::Or(hn::Gt(a, none), hn::And(hn::Eq(a, none), hn::Gt(b, none)));
    const NI bias = hn::IfThenElse(own, none, narrow_set(-1));
    const NI e = floor_to_int((t.exact[k] + wide(bias)) * wide(1.0 / kSubpixels));
    t.e[k] = hn::IfThenElse(t.large, narrow_set(TriangleRecord::kLarge), e);
  }
}

/// TriangleRecord::blocks: those in which no edge function is negative all over.
HWY_INLINE NI find_blocks(const Triangles& t) {
  const NI none = narrow_set(0), reach_x = t.last_x - t.origin_x, reach_y = t.last_y - t.origin_y;
  NI row[3], blocks = none;
  for (int k = 0; k < 3; ++k) {
    const NI rise = hn::Max(t.a[k], none) + hn::Max(t.b[k], none);
    row[k] = t.e[k] + rise + hn::ShiftLeft<1>(rise);  // at the largest of the first block
  }
  for (int y = 0; y < 16; y += 4) {
    NI e[3] = {row[0], row[1], row[2]};
    for (int x = 0; x < 16; x += 4) {
      const NI beyond = (reach_x - narrow_set(x)) | (reach_y - narrow_set(y));
      const NM touched = hn::Not(hn::Lt(e[0] | e[1] | e[2] | beyond, none));
      blocks = blocks | hn::IfThenElseZero(touched, narrow_set(1 << (y + x / 4)));
      for (int k = 0; k < 3; ++k) e[k] = e[k] + hn::ShiftLeft<2>(t.a[k]);
    }
    for (int k = 0; k < 3; ++k) row[k] = row[k] + hn::ShiftLeft<2>(t.b[k]);
  }
  return hn::IfThenZeroElse(hn::Gt(hn::Max(reach_x, reach_y), narrow_set(15)), blocks);
}

struct Plane {
  D constant, dx, dy;
};

/// Barycentric coordinates of corners 1 and 2: E_k / area.
HWY_INLINE void find_planes(const Triangles& t, Plane (&out)[2]) {
  const D area = t.exact[0] + t.exact[1] + t.exact[2];  // the same everywhere
  const D scale = wide(1.0) / area, step = scale * wide(double(kSubpixels));
  for (int k = 1; k < 3; ++k) out[k - 1] = {t.exact[k] * scale, wide(t.a[k]) * step, wide(t.b[k]) * step};
}

/// In double too: on slivers the terms cancel.
HWY_INLINE Plane depth_plane(const NF (&depth)[3], const Plane (&p)[2]) {
  const D d0 = hn::PromoteTo(kDouble, depth[0]);
  const D d1 = hn::PromoteTo(kDouble, depth[1]) - d0, d2 = hn::PromoteTo(kDouble, depth[2]) - d0;
  return {hn::MulAdd(d1, p[0].constant, hn::MulAdd(d2, p[1].constant, d0)), hn::MulAdd(d1, p[0].dx, d2 * p[1].dx),
          hn::MulAdd(d1, p[0].dy, d2 * p[1].dy)};
}

/// What set-up writes, before it goes lane by lane into records: their words.
struct alignas(64) Columns {
  float word[16][kLanes];
};

HWY_INLINE void put(NI v, float* p) { hn::StoreU(v, kNarrowInt, reinterpret_cast<int32_t*>(p)); }
HWY_INLINE void put(D v, float* p) { hn::StoreU(to_narrow_float(v), kNarrowFloat, p); }

HWY_INLINE void set_up_part(const CornerGroup& g, size_t i, int width, int height, Columns& out, ScreenPlanes& planes) {
  Triangles t;
  for (int k = 0; k < 3; ++k) {
    t.x[k] = narrow_load(g.x[k].v + i), t.y[k] = narrow_load(g.y[k].v + i);
    t.depth[k] = narrow_load(g.depth[k].v + i);
  }
  find_pixels(t, width, height);
  find_edges(t);
  Plane p[2];
  find_planes(t, p);
  const Plane z = depth_plane(t.depth, p);
  for (int k = 0; k < 3; ++k)
    put(t.a[k], out.word[k] + i), put(t.b[k], out.word[3 + k] + i), put(t.e[k], out.word[6 + k] + i);
  put(z.constant, out.word[9] + i), put(z.dx, out.word[10] + i), put(z.dy, out.word[11] + i);
  put(t.first_x | hn::ShiftLeft<16>(t.first_y), out.word[12] + i);
  put(t.last_x | hn::ShiftLeft<16>(t.last_y), out.word[13] + i);
  put(hn::IfThenElse(t.large, t.x[0], find_blocks(t)), out.word[14] + i), put(t.y[0], out.word[15] + i);
  for (int k = 0; k < 2; ++k) {
    put(p[k].constant, planes.constant[k].v + i);
    put(p[k].dx, planes.dx[k].v + i);
    put(p[k].dy, planes.dy[k].v + i);
  }
}

void SetUpTriangles(const CornerGroup& g, int width, int height, TriangleRecord* out, ScreenPlanes& planes) {
  static_assert(offsetof(TriangleRecord, b) == 12 && offsetof(TriangleRecord, e) == 24 &&
                offsetof(TriangleRecord, z0) == 36 && offsetof(TriangleRecord, first_x) == 48 &&
                offsetof(TriangleRecord, last_x) == 52 && offsetof(TriangleRecord, corner) == 56);
  Columns c;
  for (size_t i = 0; i < kLanes; i += kWidePart) set_up_part(g, i, width, height, c, planes);
  for (size_t i = 0; i < kLanes; i += kPart)
    for (size_t k = 0; k < 16; k += 4)
      store_rows(load(c.word[k] + i), load(c.word[k + 1] + i), load(c.word[k + 2] + i), load(c.word[k + 3] + i),
                 [&](size_t lane) { return reinterpret_cast<float*>(out + i + lane) + k; });
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(SetUpTriangles);

void set_up_triangles(const CornerGroup& group, int width, int height, TriangleRecord* out, ScreenPlanes& planes) {
  HWY_DYNAMIC_DISPATCH(SetUpTriangles)(group, width, height, out, planes);
}

Edges edges_at(const TriangleRecord& r, int x, int y) {
  // Corners 1 and 2 follow from corner 0 and the edges that lead there.
  const int64_t corner_x[3] = {r.corner.x, int64_t(r.corner.x) - r.b[2], int64_t(r.corner.x) + r.b[1]};
  const int64_t corner_y[3] = {r.corner.y, int64_t(r.corner.y) + r.a[2], int64_t(r.corner.y) - r.a[1]};
  const int64_t px = int64_t(x) * kSubpixels + kSubpixels / 2, py = int64_t(y) * kSubpixels + kSubpixels / 2;
  Edges out;
  for (int k = 0; k < 3; ++k) {
    const bool own = r.a[k] > 0 || (r.a[k] == 0 && r.b[k] > 0);
    const int from = (k + 1) % 3;
    const int64_t exact = r.a[k] * (px - corner_x[from]) + r.b[k] * (py - corner_y[from]) - (own ? 0 : 1);
    out.e[k] = exact >> 8;  // floor
  }
  return out;
}

}  // namespace aktina
#endif
