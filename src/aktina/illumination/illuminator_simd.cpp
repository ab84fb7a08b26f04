// illuminate() for many points: dispatch on model, textures and kind of light outside of the arithmetic.
#include <algorithm>

#include "aktina/illumination/illuminator.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/illumination/illuminator_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/base/simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

struct V3 {
  F x, y, z;
};
HWY_INLINE V3 broadcast(Vec3 v) { return {set(v.x), set(v.y), set(v.z)}; }
HWY_INLINE V3 load3(const float* const p[3], size_t i) { return {load(p[0] + i), load(p[1] + i), load(p[2] + i)}; }
HWY_INLINE V3 operator+(V3 a, V3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HWY_INLINE V3 operator-(V3 a, V3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE V3 operator*(V3 a, F s) { return {a.x * s, a.y * s, a.z * s}; }
HWY_INLINE F dot(V3 a, V3 b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }
HWY_INLINE F inverse_length(F squared) { return reciprocal_sqrt(hn::Max(squared, set(1e-30f))); }
HWY_INLINE V3 normalized(V3 v) { return v * inverse_length(dot(v, v)); }

/// Unit normal, directions to light and viewer, and the cosines between them.
struct Geometry {
  V3 n, l, v;
  F n_l, n_v, l_v;
};

// The models' highlights S, where n.l > 0; the formulas of their own files.
HWY_INLINE F highlight(const Lambert&, const Geometry&, F) { return zero(); }
HWY_INLINE F highlight(const Phong&, const Geometry& g, F exponent) {
  return pow(hn::MulSub(g.n_l + g.n_l, g.n_v, g.l_v), exponent);  // r.v = 2 (n.l)(n.v) - l.v
}
HWY_INLINE F highlight(const BlinnPhong&, const Geometry& g, F exponent) {
  const V3 h = g.l + g.v;  // not from 2 + 2 l.v, which loses its digits where light and viewer are opposite
  return pow((g.n_l + g.n_v) * inverse_length(dot(h, h)), exponent);
}

HWY_INLINE F highlight(const Schlick& model, const Geometry& g, F exponent) {
  const V3 h = g.l + g.v;
  const F t = model.half ? (g.n_l + g.n_v) * inverse_length(dot(h, h)) : hn::MulSub(g.n_l + g.n_l, g.n_v, g.l_v);
  const F n = hn::Max(exponent, set(1e-6f));
  const F clamped = hn::Min(t, set(1.0f));
  return hn::IfThenElseZero(t > zero(), clamped / hn::Max(fma(hn::Sub(set(1.0f), n), clamped, n), set(1e-30f)));
}

/// Unit direction to a lamp and the factor on its colour there.
struct Arrival {
  V3 l;
  F factor;
};

HWY_INLINE F cone_factor(const Lamp& lamp, V3 l) {
  const F c = zero() - dot(l, broadcast(lamp.axis));
  const F ramp = hn::Min(hn::Max(fma(c, set(lamp.ramp_scale), set(lamp.ramp_offset)), zero()), set(1.0f));
  const F factor = hn::IfThenElseZero(c >= set(lamp.outer_cosine), ramp * ramp);
  return lamp.exponent > 0 ? factor * pow(c, set(lamp.exponent)) : factor;
}

/// Two binary searches a point: lane by lane.
HWY_INLINE F table_factor(const Lamp& lamp, V3 l) {
  alignas(64) float x[kPart], y[kPart], z[kPart];
  store(l.x, x), store(l.y, y), store(l.z, z);
  for (size_t i = 0; i < kPart; ++i) x[i] = intensity(*lamp.table, lamp.axis, lamp.c0, -Vec3(x[i], y[i], z[i]));
  return load(x);
}

HWY_INLINE Arrival arrive(const Lamp& lamp, V3 x) {
  if (lamp.distant) return {broadcast(lamp.place), set(1.0f)};
  const V3 d = broadcast(lamp.place) - x;
  const F squared = hn::Max(dot(d, d), set(1e-30f));
  const F inverse = reciprocal_sqrt(squared);
  Arrival a{d * inverse, inverse * inverse};
  if (!lamp.inverse_square) {
    const Attenuation& f = lamp.attenuation;
    const F distance = squared * inverse;
    const F sum = fma(distance, fma(distance, set(f.a2), set(f.a1)), set(f.a0));
    a.factor = reciprocal(hn::Max(sum, set(1e-30f)));
    if (f.clamp) a.factor = hn::Min(a.factor, set(1.0f));
  }
  if (lamp.table) a.factor = a.factor * table_factor(lamp, a.l);
  if (lamp.cone) a.factor = a.factor * cone_factor(lamp, a.l);
  return a;
}

template <class Model>
void light_points(const Model& model, const Illuminator& light, const PointArrays& points, const LitArrays& out) {
  const SurfaceArrays* textured = points.surface;
  const Surface& s = light.surface();
  const Rgb ambient = light.ambient();
  for (size_t i = 0; i < padded(points.count); i += kPart) {
    const V3 x = load3(points.position, i), given = load3(points.normal, i);
    const V3 n = points.unit_normals ? given : normalized(given);
    const V3 v = light.viewer().distant ? broadcast(light.viewer().at) : normalized(broadcast(light.viewer().at) - x);
    const F n_v = dot(n, v);
    const F exponent = hn::Max(textured ? load(textured->exponent + i) : set(s.exponent), zero());
    F diffuse[3] = {zero(), zero(), zero()}, specular[3] = {zero(), zero(), zero()};
    for (const Lamp& lamp : light.lamps()) {
      const Arrival a = arrive(lamp, x);
      const Geometry g{n, a.l, v, dot(n, a.l), n_v, dot(a.l, v)};
      const F lit = hn::IfThenElseZero(g.n_l > zero(), a.factor);
      const F shine = lit * highlight(model, g, exponent), glow = lit * g.n_l;
      for (int k = 0; k < 3; ++k) {
        diffuse[k] = fma(glow, set(lamp.colour[k]), diffuse[k]);
        specular[k] = fma(shine, set(lamp.colour[k]), specular[k]);
      }
    }
    for (int k = 0; k < 3; ++k) {
      const F ka = textured ? load(textured->ka[k] + i) : set(s.ka[k]);
      const F kd = textured ? load(textured->kd[k] + i) : set(s.kd[k]);
      const F ks = textured ? load(textured->ks[k] + i) : set(s.ks[k]);
      store(fma(diffuse[k], kd, ka * set(ambient[k])), out.diffuse[k] + i);
      store(specular[k] * ks, out.specular[k] + i);
    }
  }
}

void LightPoints(const Illuminator& light, const PointArrays& points, const LitArrays& out) {
  std::visit(
      [&](const auto& model) {
        if constexpr (requires(Geometry g, F x) { highlight(model, g, x); }) light_points(model, light, points, out);
      },
      light.model());
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(LightPoints);

namespace {

/// illuminate() point by point, for models without a SIMD form. Padding is written, with copies of the last point.
void light_each(const Illuminator& light, const PointArrays& points, const LitArrays& out) {
  for (size_t i = 0; i < padded(points.count); ++i) {
    const size_t from = std::min(i, points.count - 1);
    const auto at = [from](const float* const p[3]) { return Vec3(p[0][from], p[1][from], p[2][from]); };
    Surface s = light.surface();
    if (points.surface && points.surface->whole) s = points.surface->whole[from];
    const Point3 x = at(points.position);
    const Vec3 n = points.unit_normals ? at(points.normal) : normalize_or(at(points.normal), {0, 0, 1});
    const Lit lit = illuminate(light.model(), s, light.lights(), light.ambient(), x, n, light.viewer().towards(x));
    for (int k = 0; k < 3; ++k) out.diffuse[k][i] = lit.diffuse[k], out.specular[k][i] = lit.specular[k];
  }
}

}  // namespace

Illuminator::Illuminator(const IlluminationModel& model, const Surface& surface, std::span<const Light> lights,
                         Rgb ambient, const Viewer& viewer)
    : model_(model), surface_(surface), lights_(lights.begin(), lights.end()), ambient_(ambient), viewer_(viewer) {
  for (const Light& light : lights) lamps_.push_back(lamp(light));
}

bool Illuminator::reads_whole_surface() const {
  const auto* phong = std::get_if<Phong>(&model_);
  if (phong) return phong->fresnel;
  return !(std::holds_alternative<Lambert>(model_) || std::holds_alternative<BlinnPhong>(model_) ||
           std::holds_alternative<Schlick>(model_));
}

void Illuminator::evaluate(const PointArrays& points, const LitArrays& out) const {
  if (points.count == 0) return;
  if (reads_whole_surface())
    light_each(*this, points, out);
  else
    HWY_DYNAMIC_DISPATCH(LightPoints)(*this, points, out);
}

}  // namespace aktina
#endif
