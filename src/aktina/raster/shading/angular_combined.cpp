// Angular interpolation with combined vectors: the turning of the lamp's direction along a scanline is given to the
// normal, which then turns alone, and the cosine is one wave. Cost: one recurrence of a cosine, a multiplication and an
// addition, a pixel and cosine, and the power. Weakness: only approximate where the lamp's direction turns (0.015 for a
// normal that turns by 20 and a lamp by 10 degrees). The paper could not be read: this is a reconstruction, exact at
// both ends and for lamps that stand still.
//
// In the manner of A. A. M. Kuijk, E. H. Blake, "Faster Phong Shading via Angular Interpolation", CGF 8(4), 1989.
#include "aktina/raster/shading/angular.h"

namespace aktina {
namespace {

class AngularCombinedShading final : public CosineShading {
 public:
  AngularCombinedShading() : CosineShading(slerp) {}

 private:
  void light_span(const SpanLight& s, const LitArrays& out) const override {
    add_light(s, CombinedPair(s.diffuse).cosine(), CombinedPair(s.highlight).cosine(), out);
  }
};

}  // namespace

extern constinit const ShadingRow angular_combined_shading = {
    {"angular_combined", "Angular interpolation, combined vector", "kuijk1989",
     "The lamp's turning along a scanline is given to the normal: the cosine is a single wave."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<AngularCombinedShading>(); }};

}  // namespace aktina
