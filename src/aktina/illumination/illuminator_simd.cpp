// illuminate() for many points: dispatch on model and kind of light outside of the arithmetic.
#include <algorithm>

#include "aktina/illumination/illuminator.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/illumination/illuminator_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "aktina/base/simd.h"
#include "aktina/illumination/coefficients_simd.h"
#include "aktina/illumination/lamps_simd.h"
#include "aktina/illumination/models_simd.h"

HWY_BEFORE_NAMESPACE();
namespace aktina::HWY_NAMESPACE {
namespace {

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

HWY_INLINE void fade(const DepthCue& cue, V3 x, Sums& sums) {
  const F d = hn::Max(dot(x - broadcast(cue.eye), broadcast(cue.forward)), zero());
  const F factor = set(1.0f) / fma(d, set(cue.k2), set(std::max(cue.k1, DepthCue::kLeast)));
  for (F(*sum)[3] : {&sums.diffuse, &sums.specular, &sums.grazing})
    for (F& value : *sum) value = value * factor;
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
    if (viewer.cue.active()) fade(viewer.cue, x, sums);
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
