// Pixels of spans, many at a time.
#include "aktina/raster/shading/angular.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/raster/shading/span_light_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/base/simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

void FillLinear(const Span& span, const float (&left)[6], const float (&right)[6], const LitArrays& out) {
  const SpanSteps steps(span);
  for (int i = 0; i < span.count; i += int(kPart)) {
    const F t = fma(to_float(hn::Iota(kInt, i)), set(steps.step), set(steps.start));
    for (int k = 0; k < 6; ++k) {
      float* to = (k < 3 ? out.diffuse[k] : out.specular[k - 3]) + span.output + i;
      store(fma(set(right[k] - left[k]), t, set(left[k])), to);
    }
  }
}

HWY_INLINE F evaluate(const Quadratics& q, F t) {
  const M second = t >= set(q.split);
  const auto c = [&](int k) HWY_ATTR { return select(second, set(q.right[k]), set(q.left[k])); };
  return fma(fma(c(2), t, c(1)), t, c(0));
}

/// a cos(x) + b sin(x), absolute error 1e-6 (|a| + |b|). @pre  |x| < 100
HWY_INLINE F wave(F a, F b, F x) {
  const I quarter = hn::NearestInt(x * set(float(2 / kPi)));
  const F k = to_float(quarter);
  const F r = hn::NegMulAdd(k, set(-4.37113883e-8f), hn::NegMulAdd(k, set(1.57079637f), x));
  const F r2 = r * r;
  F sine = fma(fma(set(-1.9515295891e-4f), r2, set(8.3321608736e-3f)), r2, set(-1.6666654611e-1f));
  sine = fma(sine * r2, r, r);
  F cosine = fma(fma(set(2.443315711809948e-5f), r2, set(-1.388731625493765e-3f)), r2, set(4.166664568298827e-2f));
  cosine = fma(cosine * r2, r2, fma(set(-0.5f), r2, set(1.0f)));
  // a cos + b sin of x = r + quarter pi / 2: each quarter turns (a, b) into (b, -a).
  const M odd = mask((quarter & set(int32_t(1))) != set(int32_t(0)));
  const M half = mask((quarter & set(int32_t(2))) != set(int32_t(0)));
  const F sum = fma(select(odd, b, a), cosine, select(odd, hn::Neg(a), b) * sine);
  return select(half, hn::Neg(sum), sum);
}

HWY_INLINE F evaluate(const Waves& w, F t) {
  const F first = wave(set(w.cosine[0]), set(w.sine[0]), t * set(w.turn[0]));
  if (w.cosine[1] == 0 && w.sine[1] == 0) return first;
  return first + wave(set(w.cosine[1]), set(w.sine[1]), t * set(w.turn[1]));
}

HWY_INLINE F between_0_and_1(F x) { return hn::Min(hn::Max(x, zero()), set(1.0f)); }

template <class Curve>
HWY_INLINE F highlight(const CosineModel& model, const Curve& curve, F t) {
  const F c = between_0_and_1(evaluate(curve, t)), n = set(model.exponent);
  if (!model.schlick) return pow(c, n);
  const F below = fma(hn::Sub(set(1.0f), hn::Max(n, set(1e-6f))), c, hn::Max(n, set(1e-6f)));
  return c / hn::Max(below, set(1e-30f));
}

HWY_INLINE F highlight(const CosineModel&, const PowerOfAngle& p, F t) {
  const F a = hn::Abs(fma(set(p.turn), t, set(p.from))), outside = hn::Max(set(p.outer) - a, zero());
  const F middle = hn::NegMulAdd(a * a, set(1 / (p.inner * p.outer)), set(1.0f));
  const F rim = outside * outside * set(1 / (p.outer * (p.outer - p.inner)));
  return select(a < set(p.inner), middle, rim) * set(p.scale);
}

/// Colours that cosine and power are multiplied by: linear along a span.
struct LampColours {
  float from[6], change[6];

  explicit LampColours(const SpanLight& s) {
    for (int k = 0; k < 6; ++k) {
      const float coefficient = k < 3 ? s.kd[k] : s.ks[k - 3];
      from[k] = coefficient * s.arriving[0][k % 3];
      change[k] = coefficient * (s.arriving[1][k % 3] - s.arriving[0][k % 3]);
    }
  }
  HWY_INLINE F diffuse(int k, F t) const { return fma(set(change[k]), t, set(from[k])); }
  HWY_INLINE F specular(int k, F t) const { return diffuse(3 + k, t); }
};

template <bool First, class Diffuse, class Highlight>
HWY_INLINE void add_lamp(const SpanLight& s, const Diffuse& diffuse, const Highlight& shine, const LitArrays& out) {
  const SpanSteps steps(s.span);
  const LampColours lamp(s);
  const bool shines = s.model.highlight != CosineModel::Highlight::none;
  for (int i = 0; i < s.span.count; i += int(kPart)) {
    const F t = fma(to_float(hn::Iota(kInt, i)), set(steps.step), set(steps.start));
    const F cosine = between_0_and_1(evaluate(diffuse, t));
    if (!First && hn::AllFalse(kFloat, cosine > zero())) continue;  // the lamp is below the horizon
    const F power = shines ? hn::IfThenElseZero(cosine > zero(), highlight(s.model, shine, t)) : zero();
    for (int k = 0; k < 3; ++k) {
      float* const d = out.diffuse[k] + s.span.output + i;
      float* const h = out.specular[k] + s.span.output + i;
      store(fma(lamp.diffuse(k, t), cosine, First ? set(s.ambient[k]) : load(d)), d);
      if (shines) {
        store(fma(lamp.specular(k, t), power, First ? zero() : load(h)), h);
      } else if (First) {
        store(zero(), h);
      }
    }
  }
}

void FillArc(const Arc& arc, float start, float step, size_t count, float* const (&out)[3]) {
  for (size_t i = 0; i < count; i += kPart) {
    const F t = fma(to_float(hn::Iota(kInt, int(i))), set(step), set(start));
    for (int k = 0; k < 3; ++k) store(wave(set(arc.a[k]), set(arc.tangent[k]), t * set(arc.angle)), out[k] + i);
  }
}

template <class Diffuse, class Highlight>
HWY_INLINE void add(const SpanLight& s, const Diffuse& diffuse, const Highlight& shine, const LitArrays& out) {
  if (s.first) {
    add_lamp<true>(s, diffuse, shine, out);
  } else {
    add_lamp<false>(s, diffuse, shine, out);
  }
}

void AddQuadratics(const SpanLight& s, const Quadratics& d, const Quadratics& h, const LitArrays& out) {
  add(s, d, h, out);
}
void AddWaves(const SpanLight& s, const Waves& d, const Waves& h, const LitArrays& out) { add(s, d, h, out); }
void AddPower(const SpanLight& s, const Waves& d, const PowerOfAngle& h, const LitArrays& out) { add(s, d, h, out); }

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(FillLinear);
HWY_EXPORT(FillArc);
HWY_EXPORT(AddQuadratics);
HWY_EXPORT(AddWaves);
HWY_EXPORT(AddPower);

void fill_linear(const Span& span, const float (&left)[6], const float (&right)[6], const LitArrays& out) {
  HWY_DYNAMIC_DISPATCH(FillLinear)(span, left, right, out);
}

void fill_arc(const Arc& arc, float start, float step, size_t count, float* const (&out)[3]) {
  HWY_DYNAMIC_DISPATCH(FillArc)(arc, start, step, count, out);
}

void fill_ambient(const Span& span, Rgb ambient, const LitArrays& out) {
  const float both[6] = {ambient.r, ambient.g, ambient.b, 0, 0, 0};
  fill_linear(span, both, both, out);
}

void add_light(const SpanLight& s, const Quadratics& diffuse, const Quadratics& highlight, const LitArrays& out) {
  HWY_DYNAMIC_DISPATCH(AddQuadratics)(s, diffuse, highlight, out);
}
void add_light(const SpanLight& s, const Waves& diffuse, const Waves& highlight, const LitArrays& out) {
  HWY_DYNAMIC_DISPATCH(AddWaves)(s, diffuse, highlight, out);
}
void add_light(const SpanLight& s, const Waves& diffuse, const PowerOfAngle& highlight, const LitArrays& out) {
  HWY_DYNAMIC_DISPATCH(AddPower)(s, diffuse, highlight, out);
}

}  // namespace aktina
#endif
