// Angular interpolation, exact: normal and direction to the lamp (for highlights: normal and half-vector, or mirror
// direction and viewer) turn uniformly on great circles along a scanline, and the cosine between them follows from
// spherical trigonometry as the sum of two waves. Cost: two recurrences of a cosine, 2 multiplications and 3 additions,
// a pixel and cosine, and the power; arc tangents a span. Weakness: the set-up of each span; depends on how the
// triangle is turned on the screen.
//
// A. A. M. Kuijk, E. H. Blake, "Faster Phong Shading via Angular Interpolation", Computer Graphics Forum 8(4), 1989.
// The formula for vectors on two different circles is corrected: its second term has sines.
#include "aktina/raster/shading/angular.h"

namespace aktina {
namespace {

class AngularShading final : public CosineShading {
 public:
  AngularShading() : CosineShading(slerp) {}

 private:
  void light_span(const SpanLight& s, const LitArrays& out) const override {
    add_light(s, turning_cosine(s.diffuse), turning_cosine(s.highlight), out);
  }
};

}  // namespace

extern constinit const ShadingRow angular_shading = {
    {"angular", "Angular interpolation, exact", "kuijk1989",
     "Vectors turn uniformly along a scanline; the cosine between two of them is the sum of two waves."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<AngularShading>(); }};

}  // namespace aktina
