// Angular interpolation by decomposition: azimuth and elevation of the lamp's direction about the circle on which the
// normal turns change linearly along a scanline, cos a = cos(elevation) cos(turn - azimuth). Cost: as the exact form.
// Weakness: only approximate where the lamp's direction turns out of that circle (0.008 for a normal that turns by 20
// and a lamp by 10 degrees), and wrong near its pole. The paper could not be read: this is a reconstruction, exact at
// both ends, for lamps that stand still, and for those that turn in the normal's plane.
//
// In the manner of A. A. M. Kuijk, E. H. Blake, "Faster Phong Shading via Angular Interpolation", CGF 8(4), 1989.
#include "aktina/raster/shading/angular.h"

namespace aktina {
namespace {

class AngularDecomposedShading final : public CosineShading {
 public:
  AngularDecomposedShading() : CosineShading(slerp) {}

 private:
  void light_span(const SpanLight& s, const LitArrays& out) const override {
    add_light(s, decomposed_cosine(s.diffuse), decomposed_cosine(s.highlight), out);
  }
};

}  // namespace

extern constinit const ShadingRow angular_decomposed_shading = {
    {"angular_decomposed", "Angular interpolation, decomposed", "kuijk1989",
     "Azimuth and elevation of the lamp about the normal's circle change linearly along a scanline."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<AngularDecomposedShading>(); }};

}  // namespace aktina
