// Pixels of spans, many at a time.
#include "aktina/raster/shading/span.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/shading/span_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/base/simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

void FillLinear(const Span& span, const float (&left)[6], const float (&right)[6], const LitArrays& out) {
  const SpanSteps steps(span);
  for (int i = 0; i < span.count; i += int(kPart)) {
    const F t = fma(to_float(hn::Iota(kInt, i)), set(steps.step), set(steps.start));
    for (int k = 0; k < 6; ++k) {
      float* to = (k < 3 ? out.diffuse[k] : out.specular[k - 3]) + span.output + i;
      store(fma(set(right[k] - left[k]), t, set(left[k])), to);
    }
  }
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(FillLinear);

void fill_linear(const Span& span, const float (&left)[6], const float (&right)[6], const LitArrays& out) {
  HWY_DYNAMIC_DISPATCH(FillLinear)(span, left, right, out);
}

}  // namespace aktina
#endif
