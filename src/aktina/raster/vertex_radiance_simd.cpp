#include "aktina/raster/raster_frame.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/vertex_radiance_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/raster/rows_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

void PutRadiance(const float* const (&channels)[3], size_t count, size_t first, bool front, float* rows) {
  for (size_t i = 0; i < padded(count); i += kPart)
    store_rows(load(channels[0] + i), load(channels[1] + i), load(channels[2] + i), zero(),
               [&](size_t lane) { return rows + VertexRadiance::row(first + i + lane, front); });
}

void TakeRadiance(const float* rows, const CornerGroup& c, int first_channel, Lanes (&out)[3][6]) {
  for (int corner = 0; corner < 3; ++corner)
    for (size_t i = 0; i < kLanes; i += kPart) {
      F columns[4];
      load_rows(
          [&](size_t lane) { return rows + VertexRadiance::row(c.vertex[corner][i + lane], c.side[i + lane] > 0); },
          columns);
      for (int k = 0; k < 3; ++k) store(columns[k], out[corner][first_channel + k].v + i);
    }
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(PutRadiance);
HWY_EXPORT(TakeRadiance);

void put_radiance(const float* const (&channels)[3], size_t count, size_t first, bool front, float* rows) {
  HWY_DYNAMIC_DISPATCH(PutRadiance)(channels, count, first, front, rows);
}

void take_radiance(const float* rows, const CornerGroup& corners, int first_channel, Lanes (&out)[3][6]) {
  HWY_DYNAMIC_DISPATCH(TakeRadiance)(rows, corners, first_channel, out);
}

}  // namespace aktina
#endif
