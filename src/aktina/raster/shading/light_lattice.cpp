#include "aktina/raster/shading/light_lattice.h"

namespace aktina {

void light_lattice(const TriangleGroup& t, const Illuminator& light, const ShadingPlan& plan, const Samples& out) {
  const auto points = lattice(plan.degree);
  for (int corner = 0; corner < 3; ++corner)
    for (int c = 0; c < out.channels(); ++c) out(corner, c) = t.radiance[corner][c];
  for (size_t point = 3; point < points.size(); ++point) {
    Lanes position[3], normal[3], diffuse[3], specular[3];
    t.interpolate(t.position, points[point], plan.perspective, position);
    t.interpolate(t.normal, points[point], plan.perspective, normal);
    light.evaluate(
        {size_t(t.count), {position[0].v, position[1].v, position[2].v}, {normal[0].v, normal[1].v, normal[2].v}},
        {{diffuse[0].v, diffuse[1].v, diffuse[2].v}, {specular[0].v, specular[1].v, specular[2].v}});
    out.store(int(point), diffuse, specular);
  }
}

namespace {

class PolynomialShading final : public ShadingMethod {
 public:
  PolynomialShading(int degree, bool perspective) : degree_(degree), perspective_(perspective) {}

  ShadingPlan plan(const Illuminator&) const override {
    return {.degree = degree_,
            .perspective = perspective_,
            .needs = ShadingPlan::kPosition | ShadingPlan::kNormal | ShadingPlan::kRadiance | ShadingPlan::kScreen};
  }
  void prepare(const TriangleGroup& t, const Illuminator& light, const Samples& out) const override {
    light_lattice(t, light, plan(light), out);
  }

 private:
  int degree_;
  bool perspective_;
};

}  // namespace

std::unique_ptr<ShadingMethod> polynomial_shading(int degree, bool perspective) {
  return std::make_unique<PolynomialShading>(degree, perspective);
}

}  // namespace aktina
