// Gouraud for the diffuse light, which changes slowly, and Phong for the highlights, which do not.
// Cost: as Phong, less the diffuse part of the model. Weakness: Mach bands of the diffuse part stay.
//
// A. Hast, T. Barrera, E. Bengtsson, "Improved Shading Performance by Avoiding Vector Normalization", WSCG 2001.
#include "aktina/raster/shading/shading_method.h"

namespace aktina {
namespace {

class HybridShading final : public ShadingMethod {
 public:
  ShadingPlan plan(const Illuminator&) const override {
    return {.kind = ShadingPlan::Kind::attributes,
            .degree = 1,
            .perspective = true,
            .channels = 6,
            .normal = true,
            .needs = ShadingPlan::kNormal | ShadingPlan::kRadiance};
  }

  void prepare(const TriangleGroup& t, const Illuminator&, const Samples& out) const override {
    for (int corner = 0; corner < 3; ++corner)
      for (int k = 0; k < 3; ++k) {
        out(corner, k) = t.normal[corner][k];
        out(corner, 3 + k) = t.radiance[corner][k];
      }
  }

  void shade(const Fragments& f, const Illuminator& light, const LitArrays& out) const override {
    light.evaluate(f.points(f.channel), out);
    f.diffuse_of(f.channel + 3, light, out);
  }
};

}  // namespace

extern constinit const ShadingRow hybrid_shading = {
    {"hybrid", "Gouraud diffuse, Phong specular", "hast2001",
     "Diffuse light interpolated from the corners, highlights evaluated at every pixel."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<HybridShading>(); }};

}  // namespace aktina
