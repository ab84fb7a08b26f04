// Angular interpolation in its most economic form: combined vectors, and the power of the highlight's cosine as three
// parabolas of the angle, which grows linearly along a scanline. Cost: two additions a pixel for the highlight, without
// multiplication, power or table; a recurrence of a cosine for the diffuse light. Weakness: as combined vectors; the
// parabolas are off by up to 0.02 for exponents of 5 to 20, 0.04 for 2 and 100, 0.11 for 200, and not made for higher
// ones. Exponents below 1 count as 1. Not for Schlick's highlight, which is no power.
//
// A. A. M. Kuijk, E. H. Blake, "Faster Phong Shading via Angular Interpolation", Computer Graphics Forum 8(4), 1989;
// the parabolas as A. A. M. Kuijk corrected them in a posting of 1991.
#include "aktina/base/error.h"
#include "aktina/raster/shading/angular.h"

namespace aktina {
namespace {

class AngularPowerShading final : public CosineShading {
 public:
  AngularPowerShading() : CosineShading(slerp) {}

  ShadingPlan plan(const Illuminator& light) const override {
    if (cosine_model(light).schlick)
      throw Error(Code::unsupported, "illumination", "this shading method interpolates a power of the cosine",
                  "lambert, phong without Fresnel, or blinn_phong");
    return CosineShading::plan(light);
  }

 private:
  void light_span(const SpanLight& s, const LitArrays& out) const override {
    const bool shines = s.model.highlight != CosineModel::Highlight::none;
    add_light(s, CombinedPair(s.diffuse).cosine(),
              power_of_angle(CombinedPair(shines ? s.highlight : s.diffuse), s.model.exponent), out);
  }
};

}  // namespace

extern constinit const ShadingRow angular_power_shading = {
    {"angular_power", "Angular interpolation, power by two additions", "kuijk1989",
     "The highlight is made of three parabolas of an angle that grows linearly along a scanline."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<AngularPowerShading>(); }};

}  // namespace aktina
