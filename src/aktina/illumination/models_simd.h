// The illumination models for many points at a time: the formulas of their own files. Included by
// illuminator_simd.cpp, once for each instruction set.

#if defined(AKTINA_ILLUMINATION_MODELS_SIMD_H_) == defined(HWY_TARGET_TOGGLE)  // per-target include guard
#ifdef AKTINA_ILLUMINATION_MODELS_SIMD_H_
#undef AKTINA_ILLUMINATION_MODELS_SIMD_H_
#else
#define AKTINA_ILLUMINATION_MODELS_SIMD_H_
#endif

#include "aktina/base/simd.h"
#include "aktina/illumination/coefficients_simd.h"
#include "aktina/illumination/model.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {

/// Unit normal, directions to light and viewer, and the cosines between them.
struct Geometry {
  V3 n, l, v;
  F n_l, n_v, l_v;
};

/// What one light of colour E / pi does: times kd and times ks. `grazing` is times Coefficients::grazing.
struct Lobes {
  F diffuse, specular, grazing;
};

/// Half vector: its cosines with normal and viewer, and the squared sine with the normal.
struct Half {
  F n_h, v_h, squared_sine;
};
HWY_INLINE Half half_of(const Geometry& g) {
  const V3 h = g.l + g.v;  // not from 2 + 2 l.v, which loses its digits where light and viewer are opposite
  const F inverse = inverse_length(dot(h, h));
  const V3 across = cross(g.n, h) * inverse;
  return {(g.n_l + g.n_v) * inverse, dot(h, g.v) * inverse, dot(across, across)};
}
HWY_INLINE F seen(const Geometry& g, F x) { return hn::IfThenElseZero(g.n_v > zero(), x); }

/// Fresnel's reflectance of a dielectric, as fresnel_dielectric(). Total reflection below g2 = 0.
HWY_INLINE F fresnel(F cosine, F eta) {
  const F c = hn::Min(hn::Max(cosine, zero()), set(1.0f)), g2 = fma(eta, eta, hn::MulSub(c, c, set(1.0f)));
  const F g = hn::Sqrt(hn::Max(g2, zero())), minus = g - c, plus = g + c;
  const F a = minus / hn::Max(plus, set(1e-20f)), b = hn::MulSub(c, plus, set(1.0f)) / fma(c, minus, set(1.0f));
  return select(g2 > zero(), set(0.5f) * a * a * fma(b, b, set(1.0f)), set(1.0f));
}

/// Torrance and Sparrow's masking over n.v.
HWY_INLINE F masking_over_view(const Geometry& g, const Half& h) {
  const F factor = (h.n_h + h.n_h) / hn::Max(h.v_h, set(1e-20f));
  const F inverse = set(1.0f) / hn::Max(g.n_v, set(1e-20f));
  const F share = hn::Min(hn::Min(inverse, factor), factor * g.n_l * inverse);
  return hn::IfThenElseZero(h.v_h > zero(), hn::Max(share, zero()));
}

// Classic highlights.
HWY_INLINE F highlight(const Lambert&, const Coefficients&, const Geometry&) { return zero(); }
HWY_INLINE F highlight(const Phong& model, const Coefficients& c, const Geometry& g) {
  const F cosine = hn::MulSub(g.n_l + g.n_l, g.n_v, g.l_v);     // r.v = 2 (n.l)(n.v) - l.v
  const F shine = pow(hn::Min(cosine, set(1.0f)), c.exponent);  // normals taken for unit may be longer
  return model.fresnel ? shine * fresnel(g.n_l, c.ior) : shine;
}
HWY_INLINE F highlight(const BlinnPhong&, const Coefficients& c, const Geometry& g) {
  const V3 h = g.l + g.v;
  return pow(hn::Min((g.n_l + g.n_v) * inverse_length(dot(h, h)), set(1.0f)), c.exponent);
}
HWY_INLINE F highlight(const Schlick& model, const Coefficients& c, const Geometry& g) {
  const V3 h = g.l + g.v;
  const F t = model.half ? (g.n_l + g.n_v) * inverse_length(dot(h, h)) : hn::MulSub(g.n_l + g.n_l, g.n_v, g.l_v);
  const F n = hn::Max(c.exponent, set(1e-6f));
  const F clamped = hn::Min(t, set(1.0f));
  return hn::IfThenElseZero(t > zero(), clamped / hn::Max(fma(hn::Sub(set(1.0f), n), clamped, n), set(1e-30f)));
}
HWY_INLINE F facets(FacetDistribution distribution, F width, const Half& h) {
  const F squared_cosine = h.n_h * h.n_h;
  switch (distribution) {
    case FacetDistribution::phong:
      return pow(hn::Min(h.n_h, set(1.0f)), width);
    case FacetDistribution::gaussian: {
      const F half_tangent = hn::Sqrt(h.squared_sine) / (set(1.0f) + hn::Max(h.n_h, zero()));
      const F turned = width * set(2.0f) * half_tangent * arc_tangent_ratio(half_tangent * half_tangent);
      return exp(zero() - turned * turned);
    }
    case FacetDistribution::trowbridge_reitz: {
      const F w2 = width * width, d = w2 / hn::Max(fma(w2, squared_cosine, h.squared_sine), set(1e-20f));
      return d * d;
    }
    default: {
      const F c2 = hn::Max(squared_cosine, set(1e-12f));
      return exp(zero() - h.squared_sine / (c2 * width * width)) / (c2 * c2);
    }
  }
}
HWY_INLINE F highlight(const TorranceSparrow& model, const Coefficients& c, const Geometry& g) {
  const Half h = half_of(g);
  return seen(g, facets(model.distribution, c.width, h) * masking_over_view(g, h) * fresnel(h.v_h, c.ior));
}

/// Models with a highlight S: kd n.l + ks S.
template <class Model>
HWY_INLINE auto respond(const Model& model, const Coefficients& c, const Geometry& g)
    -> decltype(Lobes{highlight(model, c, g), zero(), zero()}) {
  const M lit = g.n_l > zero();
  return {hn::IfThenElseZero(lit, g.n_l), hn::IfThenElseZero(lit, highlight(model, c, g)), zero()};
}

HWY_INLINE Lobes respond(const Constant&, const Coefficients&, const Geometry& g) {
  return {hn::Max(g.n_v, zero()), zero(), zero()};
}
HWY_INLINE Lobes respond(const Ambient&, const Coefficients&, const Geometry&) { return {zero(), zero(), zero()}; }

// Models that are defined by a BRDF: pi f n.l, where light and viewer are in front.
HWY_INLINE M both(const Geometry& g) { return hn::And(g.n_l > zero(), g.n_v > zero()); }

HWY_INLINE Lobes respond(const OrenNayar& model, const Coefficients&, const Geometry& g) {
  const OrenNayarFactors f = oren_nayar_factors(model.sigma);
  const F along = hn::Max(hn::NegMulAdd(g.n_l, g.n_v, g.l_v), zero());
  const F value = fma(set(f.b), along / hn::Max(hn::Max(g.n_l, g.n_v), set(1e-20f)), set(f.a));
  return {hn::IfThenElseZero(both(g), g.n_l * value), zero(), zero()};
}

HWY_INLINE Lobes respond(const CookTorrance&, const Coefficients& c, const Geometry& g) {
  const Half h = half_of(g);
  const F m2 = c.width * c.width, c2 = hn::Max(h.n_h * h.n_h, set(1e-12f));
  const F d = exp(zero() - h.squared_sine / (c2 * m2)) / (m2 * c2 * c2);
  const F lobe = d * masking_over_view(g, h) * fresnel(h.v_h, c.ior);
  return {hn::IfThenElseZero(both(g), g.n_l), hn::IfThenElseZero(both(g), lobe), zero()};
}

HWY_INLINE Lobes respond(const Ward&, const Coefficients& c, const Geometry& g) {
  const V3 h = g.l + g.v;
  const F squared = fma(g.n.x, g.n.x, g.n.z * g.n.z), inverse = inverse_length(squared);
  const M turned = squared > set(1e-30f);
  const V3 t{select(turned, g.n.z * inverse, set(1.0f)), zero(), hn::IfThenElseZero(turned, zero() - g.n.x * inverse)};
  const F x = dot(h, t) / c.width, y = dot(h, cross(g.n, t)) / c.width_across;
  const F z = hn::Max(g.n_l + g.n_v, set(1e-6f));
  const F lobe = exp(zero() - fma(x, x, y * y) / (z * z)) * g.n_l /
                 (set(4.0f) * c.width * c.width_across * hn::Sqrt(hn::Max(g.n_l * g.n_v, set(Ward::kLeast))));
  return {hn::IfThenElseZero(both(g), g.n_l), hn::IfThenElseZero(both(g), lobe), zero()};
}

/// Coat and metal are a + b w in Schlick's weight w: Coefficients has a as ks and b as `grazing`, and the body's share.
HWY_INLINE Lobes respond(const Ggx&, const Coefficients& c, const Geometry& g) {
  const Half h = half_of(g);
  const F a2 = c.width * c.width;
  const F i = g.n_v * hn::Sqrt(fma(hn::Sub(set(1.0f), a2), g.n_l * g.n_l, a2));
  const F o = g.n_l * hn::Sqrt(fma(hn::Sub(set(1.0f), a2), g.n_v * g.n_v, a2));
  const F d = fma(h.n_h * h.n_h, a2, h.squared_sine);
  const F lobe = a2 * g.n_l * set(0.5f) / (hn::Max(d * d, set(1e-30f)) * hn::Max(i + o, set(1e-20f)));
  const F grazing = set(1.0f) - hn::Min(hn::Max(h.v_h, zero()), set(1.0f)), g2 = grazing * grazing;
  const F w = g2 * g2 * grazing;
  const F body = set(1.0f) - fma(w, c.coat_grazing - c.coat_most, c.coat_most);
  const F shine = hn::IfThenElseZero(hn::And(both(g), h.n_h > zero()), lobe);
  return {hn::IfThenElseZero(both(g), g.n_l * body), shine, shine * w};
}

}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
