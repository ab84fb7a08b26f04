// Constant shading: one evaluation of the illumination model for each triangle, at its centroid with its own normal.
// Cost: one evaluation a triangle, nothing a pixel. Exact for a true polyhedron with light and viewer far away.
// Weakness: every edge of a curved surface shows, and lateral inhibition exaggerates it (Mach bands).
//
// W. J. Bouknight, "A Procedure for Generation of Three-Dimensional Half-Toned Computer Graphics Presentations",
// Comm. ACM 13(9), 1970.
#include "aktina/raster/shading/shading_method.h"

namespace aktina {
namespace {

class FlatShading final : public ShadingMethod {
 public:
  ShadingPlan plan(const Illuminator&) const override {
    return {.degree = 0, .needs = ShadingPlan::kPosition | ShadingPlan::kFaceNormal};
  }

  void prepare(const TriangleGroup& t, const Illuminator& light, const Samples& out) const override {
    Lanes centroid[3], diffuse[3], specular[3];
    t.interpolate(t.position, lattice(0)[0], true, centroid);
    light.evaluate({size_t(t.count),
                    {centroid[0].v, centroid[1].v, centroid[2].v},
                    {t.face_normal[0].v, t.face_normal[1].v, t.face_normal[2].v}},
                   {{diffuse[0].v, diffuse[1].v, diffuse[2].v}, {specular[0].v, specular[1].v, specular[2].v}});
    out.store(0, diffuse, specular);
  }
};

}  // namespace

extern constinit const ShadingRow flat_shading = {
    {"flat", "Constant shading", "bouknight1970",
     "One evaluation a triangle with its own normal; every edge shows as a Mach band."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<FlatShading>(); }};

}  // namespace aktina
