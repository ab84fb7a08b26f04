// Three tiers: the highlight of a triangle is Phong's where it can be strong, fence shading's where it can only be
// weak, and Gouraud's where there can be none to speak of. Diffuse light is Gouraud's on all tiers, so that neighbours
// on different ones differ by their highlights' errors alone. Cost: a test a triangle and lamp; then that of the tier.
// Weakness: where tiers meet the light jumps, by less than the weak highlight that counts as none. The publication's
// rule could not be read; shares of the highlight's peak take its place.
//
// Tai, Hsu, three-tier shading, 2002.
#include <algorithm>

#include "aktina/raster/shading/highlight_form.h"
#include "aktina/raster/shading/span.h"

namespace aktina {
namespace {

/// The fence: highlights at both ends of at most eight spans, linear between them.
void draw_fence(std::span<const Span> spans, const SpanEnds& ends, const Illuminator& light, const LitArrays& out) {
  Lanes diffuse[3], specular[3];
  light.evaluate({kLanes,
                  {ends.position[0].v, ends.position[1].v, ends.position[2].v},
                  {ends.normal[0].v, ends.normal[1].v, ends.normal[2].v}},
                 {{diffuse[0].v, diffuse[1].v, diffuse[2].v}, {specular[0].v, specular[1].v, specular[2].v}});
  for (size_t s = 0; s < spans.size(); ++s) {
    const Span& span = spans[s];
    const SpanSteps steps(span);
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < span.count; ++i) {
        const float t_i = steps.start + float(i) * steps.step;
        out.specular[k][span.output + size_t(i)] = (1 - t_i) * specular[k][2 * s] + t_i * specular[k][2 * s + 1];
      }
  }
}

class TaiHsuShading final : public ShadingMethod {
 public:
  TaiHsuShading(float strong, float weak) : strong_(strong), weak_(weak) {}

  ShadingPlan plan(const Illuminator& light) const override {
    highlight_curve(light, "tai_hsu");
    return plan_of_highlights();
  }

  void shade_spans(const TriangleGroup& t, int lane, std::span<const Span> spans, const Illuminator& light,
                   const LitArrays& out) const override {
    const CornerValues corners(t, lane);
    const bool strong = can_show(strong_, corners, light), weak = !strong && can_show(weak_, corners, light);
    visit_pixels(t, lane, spans, [&](const SpanPixels& pixels) {
      shade_linear(corners, pixels, !strong && !weak, out);
      if (strong) shade_highlights(corners, pixels, 0, pixels.count, light, out);
    });
    if (weak)
      for_span_ends(t, lane, spans, linear,
                    [&](std::span<const Span> some, const SpanEnds& ends) { draw_fence(some, ends, light, out); });
  }

 private:
  static bool can_show(float share, const CornerValues& c, const Illuminator& light) {
    const HighlightCurve curve = highlight_curve(light, "tai_hsu");
    const float least = curve.cosine_at(share);
    for (const Lamp& lamp : light.lamps())
      if (may_shine(curve, least, lamp, light.viewer(), c.position, c.normal)) return true;
    return false;
  }

  float strong_, weak_;
};

constexpr Param kParams[] = {
    {"strong", "1", "Phong where the highlight can exceed this share of its peak", 0.25, 0, 2},
    {"weak", "1", "fence shading where it can exceed this share; else Gouraud", 1.0 / 512, 0, 2}};

}  // namespace

extern constinit const ShadingRow tai_hsu_shading = {
    {"tai_hsu", "Tai and Hsu's three tiers", "tai2002",
     "Highlights by Phong, fence shading or Gouraud, as strong as a triangle can show them; Gouraud's diffuse light.",
     kParams},
    [](const ParamSet& p) -> std::unique_ptr<ShadingMethod> {
      return std::make_unique<TaiHsuShading>(float(p["strong"]), float(p["weak"]));
    }};

}  // namespace aktina
