#include "aktina/raster/plane_layout.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/planes_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/raster/rows_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

/// Values of sixteen triangles, column by column, before they go to their places.
struct Columns {
  Lanes v[kMostPlaneValues + 3];
};

/// The plane through values at the three corners.
HWY_INLINE void plane(F v0, F v1, F v2, const ScreenPlanes& p, size_t i, Lanes* out) {
  const F d1 = v1 - v0, d2 = v2 - v0;
  store(fma(d1, load(p.constant[0].v + i), fma(d2, load(p.constant[1].v + i), v0)), out[0].v + i);
  store(fma(d1, load(p.dx[0].v + i), d2 * load(p.dx[1].v + i)), out[1].v + i);
  store(fma(d1, load(p.dy[0].v + i), d2 * load(p.dy[1].v + i)), out[2].v + i);
}

/// Weights 1 / w of the corners, or ones.
struct Weights {
  F w[3];
  HWY_INLINE Weights(const CornerGroup& g, size_t i, bool perspective) {
    for (int k = 0; k < 3; ++k) w[k] = perspective ? load(g.depth[k].v + i) : set(1.0f);
  }
};

HWY_INLINE void surface_planes(const CornerGroup& g, const ScreenPlanes& p, const Weights& w, size_t i, Lanes* out) {
  const F side = load(g.side.v + i);
  for (int vertex = 1; vertex < 3; ++vertex) {
    F at[3];
    for (int corner = 0; corner < 3; ++corner) {
      if (g.clipped) {
        at[corner] = load(g.barycentric[corner][vertex].v + i);
      } else {  // corners 1 and 2 of a back have changed places
        const F front = set(corner == vertex ? 1.0f : 0.0f), back = set(corner == 3 - vertex ? 1.0f : 0.0f);
        at[corner] = select(side > zero(), front, back);
      }
    }
    plane(at[0] * w.w[0], at[1] * w.w[1], at[2] * w.w[2], p, i, out + 3 * (vertex - 1));
  }
}

HWY_INLINE void screen_planes(const ScreenPlanes& p, const Weights& w, size_t i, Lanes* out) {
  plane(zero(), w.w[1], zero(), p, i, out);
  plane(zero(), zero(), w.w[2], p, i, out + 3);
}

HWY_INLINE void polynomial(const PlaneLayout& layout, const Lanes* samples, size_t i, Lanes* out) {
  const int n = layout.terms();
  const float* matrix = lattice_to_polynomial(layout.degree);
  for (int term = 0; term < n; ++term) {
    F sum = zero();
    for (int point = 0; point < n; ++point)
      sum = fma(set(matrix[term * n + point]), load(samples[point * layout.channels].v + i), sum);
    store(sum, out[term].v + i);
  }
}

HWY_INLINE void channel(const PlaneLayout& layout, const Lanes* samples, const ScreenPlanes& p, const Weights& w,
                        size_t i, Lanes* out) {
  const auto sample = [&](int point) HWY_ATTR { return load(samples[point * layout.channels].v + i); };
  if (layout.degree == 0) {
    store(sample(0), out->v + i);
  } else if (layout.degree == 1) {
    plane(sample(0) * w.w[0], sample(1) * w.w[1], sample(2) * w.w[2], p, i, out);
  } else {
    polynomial(layout, samples, i, out);
  }
}

/// Columns to rows, four by four.
HWY_INLINE void write_rows(const Columns& columns, int size, float* out, size_t stride) {
  for (int k = 0; k < size; k += 4)
    for (size_t i = 0; i < kLanes; i += kPart)
      store_rows(load(columns.v[k].v + i), load(columns.v[k + 1].v + i), load(columns.v[k + 2].v + i),
                 load(columns.v[k + 3].v + i), [&](size_t lane) { return out + (i + lane) * stride + k; });
}

void WritePlanes(const PlaneLayout& layout, const CornerGroup& group, const ScreenPlanes& planes, bool perspective_view,
                 const Lanes* samples, float* out, size_t stride) {
  Columns columns;
  for (size_t i = 0; i < kLanes; i += kPart) {
    const Weights surface(group, i, perspective_view), weights(group, i, perspective_view && layout.perspective);
    if (layout.surface) surface_planes(group, planes, surface, i, columns.v);
    if (layout.degree >= 2) screen_planes(planes, weights, i, columns.v + layout.screen_at());
    for (int c = 0; c < layout.channels; ++c)
      channel(layout, samples + c, planes, weights, i, columns.v + layout.channel_at(c));
  }
  for (int k = layout.size(); k < (layout.size() + 3) / 4 * 4; ++k) columns.v[k] = Lanes{};
  write_rows(columns, layout.size(), out, stride);
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(WritePlanes);

void write_planes(const PlaneLayout& layout, const CornerGroup& group, const ScreenPlanes& planes,
                  bool perspective_view, const Lanes* samples, float* out, size_t stride) {
  HWY_DYNAMIC_DISPATCH(WritePlanes)(layout, group, planes, perspective_view, samples, out, stride);
}

}  // namespace aktina
#endif
