// The squared sine of the highlight's angle (for Phong's model, of half of it, twice) as a quadratic Bezier triangle
// through its values at the corners and at the middles of the edges; the highlight is a power of it. The control values
// bound it: where the least of them is beyond the highlight the triangle has none, and is left to Gouraud, whose
// diffuse light all triangles have. Cost: six samples a lamp and triangle, two additions and a power a pixel, nothing
// more where there is no highlight. Weakness: over large angles the sine's square is no quadratic; the bound is that of
// the interpolated sine.
//
// R. Brown, "Modeling Specular Highlights Using Bezier Triangles", Sun Microsystems Laboratories, TR-99-75, 1999; US
// patents 6,226,007 and 6,545,677.
#include <algorithm>
#include <optional>

#include "aktina/raster/shading/highlight_form.h"

namespace aktina {
namespace {

/// u = sum l_i^2 corner_i + 2 sum l_i l_j edge_ij.
struct BezierHighlight {
  float corner[3], edge[3];  // edges 01, 12, 20

  BezierHighlight(const HighlightCurve& curve, const Illuminator& light, size_t lamp, const CornerValues& c,
                  const CornerHighlights& h) {
    for (int v = 0; v < 3; ++v) corner[v] = curve.fall(h.corner[v].cosine);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const Point3 middle = 0.5f * (c.position[i] + c.position[j]);
      const Vec3 normal = normalize_or(c.normal[i] + c.normal[j], c.normal[i]);
      const float u = curve.fall(corner_highlight(curve, light, lamp, middle, normal).cosine);
      edge[i] = 2 * u - 0.5f * (corner[i] + corner[j]);
    }
  }

  float least() const { return std::min(*std::min_element(corner, corner + 3), *std::min_element(edge, edge + 3)); }

  QuadraticForm form() const {
    const auto& [u0, u1, u2] = corner;
    const auto& [u01, u12, u20] = edge;  // with b0 = 1 - b1 - b2
    return {{u0, 2 * (u01 - u0), 2 * (u20 - u0), u0 + u1 - 2 * u01, 2 * (u0 + u12 - u01 - u20), u0 + u2 - 2 * u20}};
  }
};

class BrownShading final : public ShadingMethod {
 public:
  explicit BrownShading(float share) : share_(share) {}

  ShadingPlan plan(const Illuminator& light) const override {
    sole_highlight_curve(light, "brown");
    return plan_of_highlights();
  }

  void shade_spans(const TriangleGroup& t, int lane, std::span<const Span> spans, const Illuminator& light,
                   const LitArrays& out) const override {
    const HighlightCurve curve = sole_highlight_curve(light, "brown");
    const float dark = curve.fall(curve.cosine_at(share_));
    shade_by_lamp(t, lane, spans, curve, light, out,
                  [&](const CornerValues& c, const CornerHighlights& h, size_t lamp) -> std::optional<QuadraticForm> {
                    const BezierHighlight bezier(curve, light, lamp, c, h);
                    if (bezier.least() > dark) return {};
                    return bezier.form();
                  });
  }

 private:
  float share_;
};

constexpr Param kParams[] = {
    {"share", "1", "a highlight counts where it exceeds this share of its peak", 1.0 / 512, 0, 1}};

}  // namespace

extern constinit const ShadingRow brown_shading = {
    {"brown", "Brown's Bezier triangles", "brown1999",
     "The highlight's angle as a quadratic through six samples, whose bound tells where there is none.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<ShadingMethod> {
      return std::make_unique<BrownShading>(float(p["share"]));
    }};

}  // namespace aktina
