// Gouraud everywhere, and Phong's highlight only on triangles that can show one: the largest n.h of a triangle tells,
// found exactly from its corners. Diffuse light is Gouraud's on all triangles, so that tested and untested neighbours
// agree along their edges. Cost: Gouraud, a test a triangle and lamp, and the highlight where it is. Weakness: Mach
// bands of the diffuse part stay; a normal map's bumps are not seen by the test.
//
// D. A. Harrison, D. Mitchell, A. H. Watt, "The H-test, a Method of High Speed Interpolative Shading", New Trends in
// Computer Graphics (CGI), 1988.
#include <algorithm>

#include "aktina/raster/shading/highlight.h"

namespace aktina {
namespace {

class HTestShading final : public ShadingMethod {
 public:
  explicit HTestShading(float share) : share_(share) {}

  ShadingPlan plan(const Illuminator& light) const override {
    highlight_curve(light, "h_test");
    return {.kind = ShadingPlan::Kind::attributes,
            .degree = 1,
            .perspective = true,
            .channels = 7,
            .normal = true,
            .needs = ShadingPlan::kPosition | ShadingPlan::kNormal | ShadingPlan::kRadiance};
  }

  void prepare(const TriangleGroup& t, const Illuminator& light, const Samples& out) const override {
    const HighlightCurve curve = highlight_curve(light, "h_test");
    const uint32_t passed = may_shine(curve, curve.cosine_at(share_), light, t);
    for (int corner = 0; corner < 3; ++corner) {
      for (int k = 0; k < 3; ++k) {
        out(corner, k) = t.normal[corner][k];
        out(corner, 3 + k) = t.radiance[corner][k];
      }
      for (size_t i = 0; i < kLanes; ++i) out(corner, 6)[i] = float(passed >> i & 1);
    }
  }

  void shade(const Fragments& f, const Illuminator& light, const LitArrays& out) const override {
    for (size_t begin = 0; begin < f.count;) {  // blocks of pixels, runs of which have passed or not
      const bool passed = any_passed(f, begin);
      size_t end = begin + kLanes;
      while (end < f.count && any_passed(f, end) == passed) end += kLanes;
      add_highlights(f, begin, std::min(end, f.count), passed, light, out);
      begin = end;
    }
    f.diffuse_of(f.channel + 3, light, out);
  }

 private:
  static bool any_passed(const Fragments& f, size_t begin) {
    return std::any_of(f.channel[6] + begin, f.channel[6] + std::min(begin + kLanes, f.count),
                       [](float flag) { return flag > 0.5f; });
  }

  static void add_highlights(const Fragments& f, size_t begin, size_t end, bool passed, const Illuminator& light,
                             const LitArrays& out) {
    if (passed) evaluate(f, begin, end - begin, light, out);
    for (int k = 0; k < 3; ++k)
      for (size_t i = begin; i < end; ++i)
        out.specular[k][i] = passed && f.channel[6][i] > 0.5f ? out.specular[k][i] : 0;
  }

  static void evaluate(const Fragments& f, size_t begin, size_t count, const Illuminator& light, const LitArrays& out) {
    const float* normal[3];
    Fragments part{count, f.channel, {}, f.surface};
    SurfaceArrays surface;
    LitArrays to;
    for (int k = 0; k < 3; ++k) {
      normal[k] = f.channel[k] + begin, part.position[k] = f.position[k] + begin;
      to.diffuse[k] = out.diffuse[k] + begin, to.specular[k] = out.specular[k] + begin;
    }
    if (f.surface) {
      surface = from(*f.surface, begin);
      part.surface = &surface;
    }
    light.evaluate(part.points(normal), to);
  }

  static SurfaceArrays from(const SurfaceArrays& s, size_t begin) {
    SurfaceArrays out = s;
    for (int k = 0; k < 3; ++k) out.ka[k] += begin, out.kd[k] += begin, out.ks[k] += begin;
    out.exponent += begin;
    if (out.whole) out.whole += begin;
    return out;
  }

  float share_;
};

constexpr Param kParams[] = {
    {"share", "1", "a highlight counts where it exceeds this share of its peak", 1.0 / 512, 0, 1}};

}  // namespace

extern constinit const ShadingRow h_test_shading = {
    {"h_test", "H-test: Gouraud, Phong's highlight where there can be one", "harrison1988",
     "Tests each triangle for a highlight; diffuse light from the corners, highlights evaluated where the test passes.",
     kParams},
    [](const ParamSet& p) -> std::unique_ptr<ShadingMethod> {
      return std::make_unique<HTestShading>(float(p["share"]));
    }};

}  // namespace aktina
