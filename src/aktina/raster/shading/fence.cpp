// Fence shading: normals are interpolated and made unit on the edges of a triangle only. The illumination model is
// evaluated at both ends of each scanline, and its result is linear between. Cost: two evaluations a scanline, one
// addition a pixel and channel. Weakness: a highlight between the ends is lost; depends on how the triangle is turned
// on the screen. Euler shading is its improvement.
//
// As A. Hast, T. Barrera, E. Bengtsson describe it: "Approximated Phong Shading by using the Euler Method",
// Eurographics 2001 (short presentations).
#include "aktina/raster/shading/span.h"

namespace aktina {
namespace {

class FenceShading final : public ShadingMethod {
 public:
  ShadingPlan plan(const Illuminator&) const override {
    return {.kind = ShadingPlan::Kind::spans, .needs = ShadingPlan::kPosition | ShadingPlan::kNormal};
  }

  void shade_spans(const TriangleGroup& triangles, int lane, std::span<const Span> spans, const Illuminator& light,
                   const LitArrays& out) const override {
    for_span_ends(triangles, lane, spans, linear, [&](std::span<const Span> some, const SpanEnds& ends) {
      Lanes lit[6];
      light.evaluate({2 * some.size(),
                      {ends.position[0].v, ends.position[1].v, ends.position[2].v},
                      {ends.normal[0].v, ends.normal[1].v, ends.normal[2].v}},
                     {{lit[0].v, lit[1].v, lit[2].v}, {lit[3].v, lit[4].v, lit[5].v}});
      for (size_t i = 0; i < some.size(); ++i) {
        float left[6], right[6];
        for (int k = 0; k < 6; ++k) left[k] = lit[k][2 * i], right[k] = lit[k][2 * i + 1];
        fill_linear(some[i], left, right, out);
      }
    });
  }
};

}  // namespace

extern constinit const ShadingRow fence_shading = {
    {"fence", "Fence shading", "hast2001euler",
     "The model at both ends of each scanline, linear between: Phong on edges, Gouraud inside."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<FenceShading>(); }};

}  // namespace aktina
