// Quadratic shading in hierarchical form: Gouraud's plane, and for each edge by how much the light in its middle
// exceeds the mean of its ends. Where no edge exceeds it by more than a threshold the triangle is plain Gouraud. Cost:
// as quadratic shading; the coefficients come from shifts and additions. Weakness: as quadratic shading. The form of
// the publication could not be read; this one is equivalent to the quadratic through the six samples.
//
// L. Seiler, "Quadratic Interpolation for Near-Phong Quality Shading", SIGGRAPH 98 Conference Abstracts, 1998.
#include <cmath>

#include "aktina/raster/shading/light_lattice.h"

namespace aktina {
namespace {

class SeilerShading final : public ShadingMethod {
 public:
  explicit SeilerShading(float threshold) : threshold_(threshold) {}

  ShadingPlan plan(const Illuminator&) const override {
    return {.degree = 2,
            .needs = ShadingPlan::kPosition | ShadingPlan::kNormal | ShadingPlan::kRadiance | ShadingPlan::kScreen};
  }

  void prepare(const TriangleGroup& t, const Illuminator& light, const Samples& out) const override {
    light_lattice(t, light, plan(light), out);
    for (int edge = 0; edge < 3; ++edge)  // I = sum l_i I_i + 4 sum l_i l_j d_ij
      for (int c = 0; c < out.channels(); ++c)
        for (size_t i = 0; i < kLanes; ++i) {
          const float mean = 0.5f * (out(edge, c)[i] + out((edge + 1) % 3, c)[i]);
          const float excess = out(3 + edge, c)[i] - mean;
          out(3 + edge, c)[i] = mean + (std::abs(excess) > threshold_ ? excess : 0);
        }
  }

 private:
  float threshold_;
};

constexpr Param kParams[] = {
    {"threshold", "cd/m^2", "edges that exceed the mean of their ends by no more stay linear", 0, 0, 1e6}};

}  // namespace

extern constinit const ShadingRow seiler_shading = {
    {"seiler", "Seiler's quadratic coefficients", "seiler1998",
     "Quadratic shading as Gouraud plus an excess for each edge, left out where it is small.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<ShadingMethod> {
      return std::make_unique<SeilerShading>(float(p["threshold"]));
    }};

}  // namespace aktina
