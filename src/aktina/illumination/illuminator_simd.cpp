// illuminate() for many points: dispatch on model and kind of light outside of the arithmetic.
#include <algorithm>

#include "aktina/illumination/illuminator.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/illumination/illuminator_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/base/simd.h"
#include "aktina/illumination/coefficients_simd.h"
#include "aktina/illumination/models_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

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

/// Sums over the lamps, each times the lamps' colours.
struct Sums {
  F diffuse[3], specular[3], grazing[3];
};

template <class Model>
HWY_INLINE void add(const Model& model, const Lamp& lamp, const Coefficients& c, V3 x, const Geometry& seen, Sums& to) {
  const Arrival a = arrive(lamp, x);
  const Lobes lobes = respond(model, c, {seen.n, a.l, seen.v, dot(seen.n, a.l), seen.n_v, dot(a.l, seen.v)});
  for (int k = 0; k < 3; ++k) {
    const F light = a.factor * set(lamp.colour[k]);
    to.diffuse[k] = fma(lobes.diffuse, light, to.diffuse[k]);
    to.specular[k] = fma(lobes.specular, light, to.specular[k]);
    if constexpr (std::is_same_v<Model, Ggx>) to.grazing[k] = fma(lobes.grazing, light, to.grazing[k]);
  }
}

template <class Model>
void light_points(const Model& model, const Illuminator& light, const PointArrays& points, const LitArrays& out) {
  const Rgb ambient = light.ambient();
  const Viewer& viewer = light.viewer();
  Coefficients c{};
  if (!points.surface) fill(model, light.surface(), points, 0, c);
  for (size_t i = 0; i < padded(points.count); i += kPart) {
    const V3 x = load3(points.position, i), given = load3(points.normal, i);
    const V3 n = points.unit_normals ? given : normalized(given);
    const V3 v = viewer.distant ? broadcast(viewer.at) : normalized(broadcast(viewer.at) - x);
    if (points.surface) fill(model, light.surface(), points, i, c);
    const Geometry seen{n, v, v, zero(), dot(n, v), zero()};
    Sums sums{{zero(), zero(), zero()}, {zero(), zero(), zero()}, {zero(), zero(), zero()}};
    for (const Lamp& lamp : light.lamps()) add(model, lamp, c, x, seen, sums);
    for (int k = 0; k < 3; ++k) {
      F specular = sums.specular[k] * c.ks[k];
      if constexpr (std::is_same_v<Model, Ggx>) specular = fma(sums.grazing[k], c.grazing[k], specular);
      store(fma(sums.diffuse[k], c.kd[k], c.ka[k] * set(ambient[k])), out.diffuse[k] + i);
      store(specular, out.specular[k] + i);
    }
  }
}

void LightPoints(const Illuminator& light, const PointArrays& points, const LitArrays& out) {
  std::visit([&](const auto& model) { light_points(model, light, points, out); }, light.model());
}

}  // namespace
}  // namespace aktina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {

HWY_EXPORT(LightPoints);

namespace {
thread_local uint64_t points_lit = 0;
}

uint64_t points_lit_by_this_thread() { return points_lit; }

Illuminator::Illuminator(const IlluminationModel& model, const Surface& surface, std::span<const Light> lights,
                         Rgb ambient, const Viewer& viewer)
    : model_(model), surface_(surface), lights_(lights.begin(), lights.end()), ambient_(ambient), viewer_(viewer) {
  for (const Light& light : lights) lamps_.push_back(lamp(light));
}

bool Illuminator::reads_whole_surface() const {
  const auto* phong = std::get_if<Phong>(&model_);
  if (phong) return phong->fresnel;
  return std::holds_alternative<TorranceSparrow>(model_) || std::holds_alternative<CookTorrance>(model_) ||
         std::holds_alternative<Ward>(model_) || std::holds_alternative<Ggx>(model_);
}

void Illuminator::evaluate(const PointArrays& points, const LitArrays& out) const {
  if (points.count == 0) return;
  points_lit += points.count;
  HWY_DYNAMIC_DISPATCH(LightPoints)(*this, points, out);
}

}  // namespace aktina
#endif
