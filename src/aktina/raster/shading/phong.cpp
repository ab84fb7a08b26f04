// Normal-vector interpolation: the vertex normals are interpolated linearly and made unit again at each pixel, where
// the illumination model is evaluated in full. Cost: an evaluation and a square root a visible pixel.
// Weakness: the angle does not grow uniformly (1.1 degrees off over a turn of 60); equal normals at the ends of an
// inflected edge look flat.
//
// B. T. Phong, "Illumination for Computer Generated Pictures", Comm. ACM 18(6), 1975.
#include "aktina/raster/shading/shading_method.h"

namespace aktina {
namespace {

class PhongShading final : public ShadingMethod {
 public:
  explicit PhongShading(bool perspective) : perspective_(perspective) {}

  ShadingPlan plan(const Illuminator&) const override {
    return {.kind = ShadingPlan::Kind::attributes,
            .degree = 1,
            .perspective = perspective_,
            .channels = 3,
            .normal = true,
            .needs = ShadingPlan::kNormal};
  }

  void prepare(const TriangleGroup& t, const Illuminator&, const Samples& out) const override {
    for (int vertex = 0; vertex < 3; ++vertex)
      for (int axis = 0; axis < 3; ++axis) out(vertex, axis) = t.normal[vertex][axis];
  }

  void shade(const Fragments& f, const Illuminator& light, const LitArrays& out) const override {
    light.evaluate(f.points(f.channel), out);  // which makes the normals unit
  }

 private:
  bool perspective_;
};

constexpr Param kParams[] = {
    {"perspective", "1", "1: linear on the surface; 0: linear on the screen, as published", 1, 0, 1, true}};

}  // namespace

extern constinit const ShadingRow phong_shading = {
    {"phong", "Phong normal interpolation", "phong1975",
     "Interpolates normals and evaluates the model at every pixel; the reference of this family.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<ShadingMethod> {
      return std::make_unique<PhongShading>(p["perspective"] != 0);
    }};

}  // namespace aktina
