// Colour that is known as a polynomial is written while triangles are scanned.
#include <hwy/cache_control.h>

#include "aktina/raster/band.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/immediate_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/raster/polynomial_simd.h"
#include "aktina/raster/scan_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

/// Coordinates that the channels' polynomials are in: pixels from the origin (degree 1), else barycentric.
template <int Degree>
HWY_INLINE void coordinates(const PlaneLayout& layout, const float* planes, F inverse_weight, F& u, F& v) {
  if constexpr (Degree >= 2) {
    const float* screen = planes + layout.screen_at();
    const F x = u, y = v;
    u = plane_at(screen, x, y) * inverse_weight, v = plane_at(screen + 3, x, y) * inverse_weight;
  }
}

template <int Degree, bool Perspective>
void draw(const TriangleChunk& chunk, const Pipeline& pipeline, size_t stride, std::span<const uint32_t> list,
          bool name_nobody, RasterBand& band) {
  const PlaneLayout planes_layout = pipeline.layout;
  const BlockLayout layout = band.visible.layout;
  const int terms = planes_layout.terms(), first_channel = planes_layout.channel_at(0);
  float* const depths = band.visible.depth.data();
  auto* const seen = reinterpret_cast<int32_t*>(band.visible.seen.data());
  float* const colours[3] = {band.colour[0].data(), band.colour[1].data(), band.colour[2].data()};
  for (size_t at_list = 0; at_list < list.size(); ++at_list) {
    const uint32_t n = list[at_list], soon = list[std::min(at_list + kAhead, list.size() - 1)];
    hwy::Prefetch(&chunk.records[soon]);
    hwy::Prefetch(chunk.planes.data() + soon * stride);
    const TriangleRecord& t = chunk.records[n];
    const float* planes = chunk.planes.data() + n * stride;
    scan(t, layout, [&](const Block& b) HWY_ATTR {
      const size_t at = b.offset;
      for (size_t p = 0; p < kParts; ++p) {
        const size_t i = at + p * kPart;
        F u = b.dx(p), v = b.dy(p);
        const F z = fma(set(t.zx), u, fma(set(t.zy), v, set(t.z0))), before = load(depths + i);
        const M nearer = hn::And(b.covered_part(p), z > before);
        if (!b.small && hn::AllFalse(kFloat, nearer)) continue;
        store(select(nearer, z, before), depths + i);
        if (name_nobody) store(select(nearer, set(int32_t(-1)), load(seen + i)), seen + i);
        const F w = Perspective ? reciprocal(select(nearer, z, set(1.0f))) : set(1.0f);
        coordinates<Degree>(planes_layout, planes, w, u, v);
        for (int k = 0; k < 3; ++k) {
          F c = polynomial_at<Degree>(planes + first_channel + k * terms, u, v);
          if constexpr (Degree >= 2) c = hn::Max(c, zero());  // they swing below zero around sharp highlights
          if constexpr (Perspective && Degree == 1) c = c * w;
          store(select(nearer, c, load(colours[k] + i)), colours[k] + i);
        }
      }
    });
  }
}

template <bool Perspective>
void draw_any(const TriangleChunk& chunk, const Pipeline& pipeline, size_t stride, std::span<const uint32_t> list,
              bool nobody, RasterBand& band) {
  switch (pipeline.layout.degree) {
    case 0:
      return draw<0, Perspective>(chunk, pipeline, stride, list, nobody, band);
    case 1:
      return draw<1, Perspective>(chunk, pipeline, stride, list, nobody, band);
    case 2:
      return draw<2, Perspective>(chunk, pipeline, stride, list, nobody, band);
    default:
      return draw<3, Perspective>(chunk, pipeline, stride, list, nobody, band);
  }
}

void DrawImmediate(const TriangleChunk& chunk, const Pipeline& pipeline, size_t stride, bool perspective_view,
                   std::span<const uint32_t> list, RasterBand& band) {
  const bool nobody = band.names;
  if (perspective_view && pipeline.layout.perspective && pipeline.layout.degree > 0) {
    draw_any<true>(chunk, pipeline, stride, list, nobody, band);
  } else {
    draw_any<false>(chunk, pipeline, stride, list, nobody, band);
  }
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(DrawImmediate);

void draw_immediate(const TriangleChunk& chunk, const Pipeline& pipeline, size_t stride, bool perspective_view,
                    std::span<const uint32_t> list, RasterBand& band) {
  HWY_DYNAMIC_DISPATCH(DrawImmediate)(chunk, pipeline, stride, perspective_view, list, band);
}

}  // namespace aktina
#endif
