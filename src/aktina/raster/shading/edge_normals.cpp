#include "aktina/raster/shading/edge_normals.h"

namespace aktina {

namespace {

class EdgeNormalShading final : public ShadingMethod {
 public:
  EdgeNormalShading(EdgeNormal middle, bool unit) : middle_(middle), unit_(unit) {}

  ShadingPlan plan(const Illuminator&) const override {
    return {.kind = ShadingPlan::Kind::attributes,
            .degree = 2,
            .perspective = true,
            .channels = 3,
            .normal = true,
            .needs = ShadingPlan::kPosition | ShadingPlan::kNormal};
  }

  void prepare(const TriangleGroup& t, const Illuminator&, const Samples& out) const override {
    for (int corner = 0; corner < 3; ++corner)
      for (int k = 0; k < 3; ++k) out(corner, k) = t.normal[corner][k];
    for (int edge = 0; edge < 3; ++edge) {
      const int a = edge, b = (edge + 1) % 3;
      const auto at = [](const Lanes(&v)[3], size_t i) { return Vec3(v[0][i], v[1][i], v[2][i]); };
      for (size_t i = 0; i < kLanes; ++i) {
        const Vec3 n = middle_(at(t.normal[a], i), at(t.normal[b], i), at(t.position[b], i) - at(t.position[a], i));
        for (int k = 0; k < 3; ++k) out(3 + edge, k)[i] = n[k];
      }
    }
  }

  void shade(const Fragments& f, const Illuminator& light, const LitArrays& out) const override {
    PointArrays points = f.points(f.channel);
    points.unit_normals = unit_;
    light.evaluate(points, out);
  }

 private:
  EdgeNormal middle_;
  bool unit_;
};

}  // namespace

std::unique_ptr<ShadingMethod> edge_normal_shading(EdgeNormal middle, bool unit) {
  return std::make_unique<EdgeNormalShading>(middle, unit);
}

}  // namespace aktina
