// Light of a span, lamp by lamp, for methods that follow cosines along it instead of evaluating a model at each pixel.
//
// What such a method interpolates is the angle between two unit vectors that turn from one end of the span to the
// other: normal and direction to the lamp for the diffuse light; for the highlight normal and half-vector (Blinn), or
// mirror direction and viewer (Phong). That is why it works with models that are functions of these cosines only.
#pragma once

#include "aktina/raster/shading/span.h"

namespace aktina {

/// Unit vectors p and q at the left and the right end of a span.
struct TurningPair {
  Vec3 p[2], q[2];
};

/// An illumination model as a function of cosines.
struct CosineModel {
  enum class Highlight { none, normal_half, mirror_viewer };
  Highlight highlight = Highlight::none;
  bool schlick = false;  // t / (n - n t + t) instead of t^n
  float exponent = 1;
};

/// @throws Error unsupported, naming the models that are such functions
CosineModel cosine_model(const Illuminator& light);

/// One lamp on one span.
struct SpanLight {
  const Span& span;
  const CosineModel& model;
  Rgb kd, ks;
  bool first;                      // on this span: what the arrays hold is overwritten by
  Rgb ambient;                     // reflected ambient light
  Rgb arriving[2];                 // E / pi on a plane that faces the lamp, at the ends; linear between
  TurningPair diffuse, highlight;  // no highlight where the model has none
};

/// c0 + c1 t + c2 t^2, with other coefficients from t = split on: two additions a pixel.
struct Quadratics {
  float split = kInfinity;
  float left[3], right[3];
  static Quadratics whole(float c0, float c1, float c2) { return {kInfinity, {c0, c1, c2}, {c0, c1, c2}}; }
};

/// The sum of two waves, cosine[k] cos(turn[k] t) + sine[k] sin(turn[k] t): two recurrences of a cosine.
struct Waves {
  float cosine[2] = {}, sine[2] = {}, turn[2] = {};
};

/// scale * cos^n(from + turn t), where the power is made of three parabolas: height 1 at the angle 0, joined at `inner`
/// and zero beyond `outer`. Two additions a pixel.
struct PowerOfAngle {
  float scale, from, turn, inner, outer;
};

/// Adds a lamp to what a span shows. Cosines are cut off at 0 and 1; a highlight needs a lamp above the horizon.
void add_light(const SpanLight& s, const Quadratics& diffuse, const Quadratics& highlight, const LitArrays& out);
void add_light(const SpanLight& s, const Waves& diffuse, const Waves& highlight, const LitArrays& out);
void add_light(const SpanLight& s, const Waves& diffuse, const PowerOfAngle& highlight, const LitArrays& out);

/// Methods that do with each lamp on each span the same.
class CosineShading : public ShadingMethod {
 public:
  ShadingPlan plan(const Illuminator& light) const override;
  void shade_spans(const TriangleGroup& triangles, int lane, std::span<const Span> spans, const Illuminator& light,
                   const LitArrays& out) const override;

 protected:
  explicit CosineShading(NormalBetween on_edges) : on_edges_(on_edges) {}

  /// Finds the curves of the cosines and calls add_light().
  virtual void light_span(const SpanLight& span, const LitArrays& out) const = 0;

 private:
  NormalBetween on_edges_;
};

/// What a span shows without lamps.
void fill_ambient(const Span& span, Rgb ambient, const LitArrays& out);

}  // namespace aktina
