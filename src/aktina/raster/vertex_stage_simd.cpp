#include "aktina/raster/vertex_stage.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/vertex_stage_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/raster/rows_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

/// Row of a matrix times (x, y, z, 1).
HWY_INLINE F row_times(const Mat4& m, int row, F x, F y, F z) {
  return fma(x, set(m[0][row]), fma(y, set(m[1][row]), fma(z, set(m[2][row]), set(m[3][row]))));
}

/// The bit of a plane where the signed distance to it is not positive or zero; NaN is beyond every plane.
HWY_INLINE I beyond(F distance, int32_t bit) { return select(distance >= zero(), set(int32_t(0)), set(bit)); }

void ProjectVertices(const DrawList& list, const View& view, size_t begin, size_t end, ScreenVertices& out) {
  const Mat4& m = view.clip_from_world();
  const F near = set(view.near()), far = set(view.far());
  const F half_width = set(0.5f * float(view.width())), half_height = set(0.5f * float(view.height()));
  const F guard_x = set(2 * kGuardBand / float(view.width()) - 1),
          guard_y = set(2 * kGuardBand / float(view.height()) - 1);
  const F picture_x = set(1 + 2 / float(view.width())), picture_y = set(1 + 2 / float(view.height()));
  for (size_t i = begin; i < padded(end); i += kPart) {
    const F px = load(list.position(0) + i), py = load(list.position(1) + i), pz = load(list.position(2) + i);
    const F x = row_times(m, 0, px, py, pz), y = row_times(m, 1, px, py, pz);
    const F distance = row_times(m, 2, px, py, pz), w = row_times(m, 3, px, py, pz);
    const F limit_x = guard_x * w, limit_y = guard_y * w;
    const I sides = beyond(limit_x - x, 4) | beyond(limit_x + x, 8) | beyond(limit_y - y, 16) | beyond(limit_y + y, 32);
    const I outside = beyond(distance - near, 1) | select(distance <= far, set(int32_t(0)), set(int32_t(2))) | sides;
    const F edge_x = picture_x * w, edge_y = picture_y * w;
    const I beside =
        beyond(edge_x - x, 64) | beyond(edge_x + x, 128) | beyond(edge_y - y, 256) | beyond(edge_y + y, 512);
    const F weight = set(1.0f) / w, subpixels = set(float(kSubpixels));
    const I screen_x = hn::NearestInt(fma(x * weight, half_width, half_width) * subpixels);
    const I screen_y = hn::NearestInt(hn::NegMulAdd(y * weight, half_height, half_height) * subpixels);
    store_rows(bits_of(screen_x), bits_of(screen_y), view.perspective() ? weight : zero() - distance,
               bits_of(outside | beside), [&](size_t lane) { return out.data() + 4 * (i + lane); });
  }
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(ProjectVertices);

void project_vertices(const DrawList& list, const View& view, size_t begin, size_t end, ScreenVertices& out) {
  HWY_DYNAMIC_DISPATCH(ProjectVertices)(list, view, begin, end, out);
}

}  // namespace aktina
#endif
