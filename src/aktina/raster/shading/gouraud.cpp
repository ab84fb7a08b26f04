// Intensity interpolation: the illumination model is evaluated at the vertices, with vertex normals, and its result is
// interpolated linearly. Cost: one evaluation a vertex, one addition a pixel and channel.
// Weakness: a highlight within a triangle is lost; the first derivative jumps at edges (Mach bands). Linear on the
// screen, as published, the colours swim as the view turns; `perspective` interpolates on the surface instead.
//
// H. Gouraud, "Continuous Shading of Curved Surfaces", IEEE Trans. Computers C-20(6), 1971.
#include "aktina/raster/shading/shading_method.h"

namespace aktina {
namespace {

class GouraudShading final : public ShadingMethod {
 public:
  explicit GouraudShading(bool perspective) : perspective_(perspective) {}

  ShadingPlan plan(const Illuminator&) const override {
    return {.degree = 1, .perspective = perspective_, .needs = ShadingPlan::kRadiance};
  }

  void prepare(const TriangleGroup& t, const Illuminator&, const Samples& out) const override {
    for (int vertex = 0; vertex < 3; ++vertex)
      for (int c = 0; c < t.channels; ++c) out(vertex, c) = t.radiance[vertex][c];
  }

 private:
  bool perspective_;
};

constexpr Param kParams[] = {
    {"perspective", "1", "1: linear on the surface; 0: linear on the screen, as published", 0, 0, 1, true}};

}  // namespace

extern constinit const ShadingRow gouraud_shading = {
    {"gouraud", "Gouraud intensity interpolation", "gouraud1971",
     "One evaluation a vertex, one addition a pixel; loses highlights smaller than a triangle.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<ShadingMethod> {
      return std::make_unique<GouraudShading>(p["perspective"] != 0);
    }};

}  // namespace aktina
