// Gouraud on triangles that can show no highlight; others are split in four, at the middles of their edges, and each
// part is Gouraud's or split again. Whether an edge has a point of its own in its middle is asked of the edge alone,
// and a triangle with such an edge is split: neighbours agree along what they share. Where an edge has none, its middle
// is the mean of its ends. Cost: Gouraud where there is no highlight; up to 4^depth Gouraud triangles where there is
// one. Weakness: highlights smaller than the smallest parts are missed; the diffuse light is refined near highlights
// only.
//
// Y. Cho, U. Neumann, J. Woo, "Improved Specular Highlights with Adaptive Shading", CGI 1996.
#include <algorithm>

#include "aktina/raster/shading/highlight_form.h"
#include "aktina/raster/shading/split_triangle.h"

namespace aktina {
namespace {

class ChoNeumannWooShading final : public ShadingMethod {
 public:
  ChoNeumannWooShading(int depth, float share) : depth_(depth), share_(share) {}

  ShadingPlan plan(const Illuminator& light) const override {
    highlight_curve(light, "cho_neumann_woo");
    return plan_of_highlights();
  }

  void shade_spans(const TriangleGroup& t, int lane, std::span<const Span> spans, const Illuminator& light,
                   const LitArrays& out) const override {
    const CornerValues corners(t, lane);
    const HighlightCurve curve = highlight_curve(light, "cho_neumann_woo");
    const SplitTriangle split(corners, light, curve, curve.cosine_at(share_), depth_);
    visit_pixels(t, lane, spans, [&](const SpanPixels& pixels) {
      if (!split.whole()) return split.shade(pixels, out);
      shade_linear(corners, pixels, true, out);
    });
  }

 private:
  int depth_;
  float share_;
};

constexpr Param kParams[] = {
    {"depth", "1", "how many times a triangle is split at most", 2, 0, SplitTriangle::kDeepest, true},
    {"share", "1", "a highlight counts where it exceeds this share of its peak", 1.0 / 512, 0, 1}};

}  // namespace

extern constinit const ShadingRow cho_neumann_woo_shading = {
    {"cho_neumann_woo", "Cho, Neumann and Woo's adaptive subdivision", "cho1996",
     "Gouraud; triangles that can show a highlight are split in four, again and again, without cracks.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<ShadingMethod> {
      return std::make_unique<ChoNeumannWooShading>(int(p["depth"]), float(p["share"]));
    }};

}  // namespace aktina
