#include "aktina/raster/shading/span_light.h"

#include <algorithm>

#include "aktina/base/error.h"

namespace aktina {
namespace {

template <class Model>
const Model* model_in(const Illuminator& light) {
  return std::get_if<Model>(&light.model());
}

/// What a span's ends know without lamps.
struct Ends {
  Point3 position[2];
  Vec3 normal[2], viewer[2];
  float cue[2];  // DepthCue

  Ends(const SpanEnds& ends, size_t i, const Illuminator& light) {
    for (size_t e = 0; e < 2; ++e) {
      position[e] = ends.position_of(2 * i + e);
      viewer[e] = light.viewer().towards(position[e]);
      cue[e] = light.viewer().cue.at(position[e]);
      normal[e] = normalize_or(ends.normal_of(2 * i + e), viewer[e]);
    }
  }
};

SpanLight light_of(const Span& span, const CosineModel& model, const Illuminator& light, const Ends& ends,
                   const Light& lamp) {
  const Surface& surface = light.surface();
  const bool first = &lamp == light.lights().data();
  SpanLight s{span, model, surface.kd, surface.ks, first, surface.ka * light.ambient(), {}, {}, {}};
  for (size_t e = 0; e < 2; ++e) {
    const LightSample at = sample(lamp, ends.position[e]);
    const Vec3 n = ends.normal[e], v = ends.viewer[e];
    s.arriving[e] = at.e_perp.v * (float(kInvPi) * ends.cue[e]);
    s.diffuse.p[e] = n, s.diffuse.q[e] = at.wi;
    if (model.highlight == CosineModel::Highlight::normal_half) {
      s.highlight.p[e] = n, s.highlight.q[e] = normalize_or(at.wi + v, n);
    } else {
      s.highlight.p[e] = reflect_about(n, at.wi), s.highlight.q[e] = v;
    }
  }
  return s;
}

}  // namespace

CosineModel cosine_model(const Illuminator& light) {
  using Highlight = CosineModel::Highlight;
  const float exponent = std::max(light.surface().exponent, 0.0f);
  if (model_in<Lambert>(light)) return {Highlight::none, false, exponent};
  if (model_in<BlinnPhong>(light)) return {Highlight::normal_half, false, exponent};
  if (const auto* phong = model_in<Phong>(light); phong && !phong->fresnel)
    return {Highlight::mirror_viewer, false, exponent};
  if (const auto* schlick = model_in<Schlick>(light))
    return {schlick->half ? Highlight::normal_half : Highlight::mirror_viewer, true, exponent};
  throw Error(Code::unsupported, "illumination",
              "this shading method interpolates cosines, and the model is not a function of them alone",
              "lambert, phong without Fresnel, blinn_phong or schlick");
}

ShadingPlan CosineShading::plan(const Illuminator& light) const {
  cosine_model(light);
  return {.kind = ShadingPlan::Kind::spans, .needs = ShadingPlan::kPosition | ShadingPlan::kNormal};
}

void CosineShading::shade_spans(const TriangleGroup& triangles, int lane, std::span<const Span> spans,
                                const Illuminator& light, const LitArrays& out) const {
  const CosineModel model = cosine_model(light);
  for_span_ends(triangles, lane, spans, on_edges_, [&](std::span<const Span> some, const SpanEnds& both) {
    for (size_t i = 0; i < some.size(); ++i) {
      const Ends ends(both, i, light);
      if (light.lights().empty()) fill_ambient(some[i], light.surface().ka * light.ambient(), out);
      for (const Light& lamp : light.lights()) light_span(light_of(some[i], model, light, ends, lamp), out);
    }
  });
}

}  // namespace aktina
