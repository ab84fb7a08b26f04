// Spherical interpolation: a triangle's normals are mapped onto the sphere, great circles along its edges and then
// along each scanline. They are of unit length everywhere, without a square root a pixel, and turn uniformly; the
// illumination model is evaluated at each pixel, so that every model, lamp and viewer goes. Cost: an arc tangent and a
// sine a span; a multiplication and an addition a component by the recurrence of a cosine; and the model. Weakness: the
// set-up outweighs the square root that it saves on short spans; depends a little on how the triangle is turned on the
// screen.
//
// B. Mohamed, L. Szirmay-Kalos, T. Horvath, "Hardware Implementation of Phong Shading using Spherical Interpolation",
// Periodica Polytechnica 44, 2000.
#include <algorithm>

#include "aktina/raster/shading/angular.h"

namespace aktina {
namespace {

constexpr size_t kPiece = 256;  // px at a time

class SphericalShading final : public ShadingMethod {
 public:
  ShadingPlan plan(const Illuminator&) const override {
    return {.kind = ShadingPlan::Kind::spans, .needs = ShadingPlan::kPosition | ShadingPlan::kNormal};
  }

  void shade_spans(const TriangleGroup& triangles, int lane, std::span<const Span> spans, const Illuminator& light,
                   const LitArrays& out) const override {
    for_span_ends(triangles, lane, spans, slerp, [&](std::span<const Span> some, const SpanEnds& ends) {
      for (size_t i = 0; i < some.size(); ++i)
        for (size_t done = 0; done < size_t(some[i].count); done += kPiece)
          shade_piece(ends, i, some[i], done, std::min(kPiece, size_t(some[i].count) - done), light, out);
    });
  }

 private:
  static void shade_piece(const SpanEnds& ends, size_t i, const Span& span, size_t done, size_t count,
                          const Illuminator& light, const LitArrays& out) {
    alignas(64) float position[3][kPiece], normal[3][kPiece];
    const SpanSteps steps(span);
    const float start = steps.start + float(done) * steps.step;
    fill_arc(Arc(ends.normal_of(2 * i), ends.normal_of(2 * i + 1)), start, steps.step, count,
             {normal[0], normal[1], normal[2]});
    const Point3 left = ends.position_of(2 * i), across = ends.position_of(2 * i + 1) - left;
    const float from = ends.weight[2 * i], to = ends.weight[2 * i + 1];
    for (size_t j = 0; j < padded(count); ++j) {
      const float t = std::min(start + float(j) * steps.step, 1.0f);  // padding may be far beyond
      const float s = t * to / (from + t * (to - from));
      for (int k = 0; k < 3; ++k) position[k][j] = left[k] + s * across[k];
    }
    const size_t at = span.output + done;
    light.evaluate({.count = count,
                    .position = {position[0], position[1], position[2]},
                    .normal = {normal[0], normal[1], normal[2]},
                    .unit_normals = true},
                   {{out.diffuse[0] + at, out.diffuse[1] + at, out.diffuse[2] + at},
                    {out.specular[0] + at, out.specular[1] + at, out.specular[2] + at}});
  }
};

}  // namespace

extern constinit const ShadingRow spherical_shading = {
    {"spherical", "Spherical normal interpolation", "mohamed2000",
     "Normals turn uniformly on great circles along edges and scanlines: of unit length without a square root a "
     "pixel."},
    [](const ParamSet&) -> std::unique_ptr<ShadingMethod> { return std::make_unique<SphericalShading>(); }};

}  // namespace aktina
