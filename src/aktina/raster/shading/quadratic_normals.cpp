// Normals by a quadratic through the corners' and the bisectors at the edges' middles: so nearly of unit length that
// they are used as they are. Cost: two additions a component and the illumination model a pixel; Phong's square root is
// saved. Weakness: over a turn of 60 degrees the length is off by 0.2 % (90 degrees: 1.1 %), which an exponent n
// multiplies by n: fine at a distance, not close up.
//
// L. Szirmay-Kalos, B. Mohamed, et al., "Quadratic Shading and its Hardware Implementation", Machine Graphics and
// Vision 9(4), 2000.
#include "aktina/raster/shading/edge_normals.h"

namespace aktina {
namespace {

Vec3 bisector(Vec3 n0, Vec3 n1, Vec3 /*edge*/) { return normalize_or(n0 + n1, n0); }

class QuadraticNormalsShading final : public ShadingMethod {
 public:
  ShadingPlan plan(const Illuminator&) const override {
    return {.kind = ShadingPlan::Kind::attributes,
            .degree = 2,
            .perspective = true,
            .channels = 3,
            .normal = true,
            .needs = ShadingPlan::kPosition | ShadingPlan::kNormal};
  }
  void prepare(const TriangleGroup& t, const Illuminator&, const Samples& out) const override {
    sample_edge_normals(t, bisector, out);
  }
  void shade(const Fragments& f, const Illuminator& light, const LitArrays& out) const override {
    PointArrays points = f.points(f.channel);
    points.unit_normals = true;
    light.evaluate(points, out);
  }
};

}  // namespace

extern constinit const ShadingRow quadratic_normals_shading = {
    {"quadratic_normals", "Quadratic normals without renormalisation", "szirmay2000",
     "Normals that need no square root a pixel; their length is off by 0.2 % over a turn of 60 degrees."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<QuadraticNormalsShading>(); }};

}  // namespace aktina
