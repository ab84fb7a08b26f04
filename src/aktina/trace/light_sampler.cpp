#include "aktina/trace/light_sampler.h"

#include <algorithm>
#include <cmath>

#include "aktina/trace/offset.h"

namespace aktina {

LightSampler::LightSampler(const Scene& scene)
    : scene_(&scene), sky_(scene.environment), first_(scene.instances.size(), kNothing) {
  std::vector<LampBounds> bounds;
  std::vector<const Light*> suns;
  for (const PlacedLight& placed : scene.lights) {
    if (std::holds_alternative<DirectionalLight>(placed.light)) {
      suns.push_back(&placed.light);
      continue;
    }
    Emitter emitter;
    emitter.lamp = &placed.light;
    bounds.push_back(emitter.bounds(scene));
    emitters_.push_back(emitter);
  }
  for (uint32_t i = 0; i < scene.instances.size(); ++i) add_instance(i, bounds);
  tree_.build(std::move(bounds));
  add_distant(suns);
}

void LightSampler::add_instance(uint32_t index, std::vector<LampBounds>& bounds) {
  const Instance& instance = scene_->instances[index];
  const Material& material = scene_->material_of(instance);
  if (!material.emits() || material.unlit || (instance.mesh < 0 && instance.primitive < 0)) return;
  first_[index] = uint32_t(emitter_of_.size());
  Emitter e;
  e.material = &material;
  e.to_world = instance.to_world;
  const auto add = [&] {
    LampBounds b = e.bounds(*scene_);
    if (!(b.power > 0) || !is_finite(b.box.low) || !is_finite(b.box.high)) b.power = 0;
    bounds.push_back(b);
    emitter_of_.push_back(uint32_t(emitters_.size()));
    emitters_.push_back(e);
  };
  if (instance.mesh < 0) {
    e.primitive = &scene_->primitives[size_t(instance.primitive)];
    e.area = float(area(*e.primitive));
    add();
    return;
  }
  e.mesh = &scene_->meshes[size_t(instance.mesh)];
  for (uint32_t t = 0; t < e.mesh->triangles.size(); ++t) {
    e.set_triangles(t);
    add();
    if (e.parallelogram) emitter_of_.push_back(emitter_of_.back()), ++t;
  }
}

void LightSampler::add_distant(const std::vector<const Light*>& suns) {
  double total = 0;
  const auto add = [&](const Light* lamp, double irradiance) {
    if (irradiance > 0 && std::isfinite(irradiance))
      distant_.push_back({lamp, float(irradiance), 0}), total += irradiance;
  };
  for (const Light* sun : suns) add(sun, double(luminance(std::get<DirectionalLight>(*sun).e_perp.v)));
  if (sky_.shines()) add(nullptr, kPi * double(sky_.mean_luminance()));
  distant_chance_ = distant_.empty() ? 0 : tree_.empty() ? 1 : 0.5f;
  double sum = 0;
  for (Distant& d : distant_) {
    sum += double(d.chance) / total;
    d.chance = float(double(d.chance) / total) * distant_chance_;
    d.until = float(sum);
  }
}

ArrivingLight LightSampler::sample(Point3 x, float choice, Vec2 u) const {
  if (choice < distant_chance_) return sample_distant(x, choice / distant_chance_, u);
  if (tree_.empty()) return {};
  return sample_near(x, (choice - distant_chance_) / (1 - distant_chance_), u);
}

ArrivingLight LightSampler::sample_distant(Point3 x, float choice, Vec2 u) const {
  size_t i = 0;
  while (i + 1 < distant_.size() && choice >= distant_[i].until) ++i;
  ArrivingLight out;
  out.distant = true;
  if (distant_[i].lamp) {
    const LightSample s = aktina::sample(*distant_[i].lamp, x);
    out.wi = s.wi, out.e_perp = s.e_perp.v / distant_[i].chance;
  } else {
    const EnvironmentSampler::Sample s = sky_.sample(u);
    out.wi = s.direction, out.pdf = s.pdf * distant_[i].chance;
    if (out.pdf > 0) out.e_perp = aktina::radiance(scene_->environment, out.wi).v / out.pdf;
  }
  out.target = out.wi;
  return out;
}

ArrivingLight LightSampler::sample_near(Point3 x, float choice, Vec2 u) const {
  const LightTree::Choice picked = tree_.pick(x, choice);
  const Emitter& emitter = emitters_[picked.lamp];
  const float chance = picked.chance * (1 - distant_chance_);
  ArrivingLight out;
  if (!(chance > 0)) return out;
  if (emitter.lamp) {
    const LightSample s = aktina::sample(*emitter.lamp, x);
    if (!(s.distance > 0)) return out;
    out.wi = s.wi, out.target = x + s.distance * s.wi, out.e_perp = s.e_perp.v / chance;
    return out;
  }
  const EmitterSample s = emitter.sample(u);
  const Vec3 d = s.position - x;
  const float d2 = squared_length(d);
  if (!(d2 > 0)) return out;
  out.wi = d * (1 / std::sqrt(d2));
  const float cosine = -dot(out.wi, s.normal);
  if (!(cosine > 0) && !emitter.material->double_sided) return out;
  out.pdf = chance * s.area_pdf * d2 / std::max(std::abs(cosine), 1e-9f);
  out.target = offset_point(s.position, cosine > 0 ? s.normal : -s.normal);
  if (out.pdf > 0 && out.pdf < kInfinity) out.e_perp = emitter.radiance(*scene_, s.uv) / out.pdf;
  return out;
}

float LightSampler::pdf(Point3 x, const Hit& hit, float distance, float cosine) const {
  const uint32_t first = first_[hit.instance];
  if (first == kNothing) return 0;
  const uint32_t index = emitter_of_[first + hit.triangle];
  const float chance = tree_.empty() ? 0 : tree_.chance(x, index) * (1 - distant_chance_);
  if (!(chance > 0)) return 0;
  return chance * emitters_[index].area_pdf(hit.normal) * distance * distance / std::max(cosine, 1e-9f);
}

float LightSampler::sky_pdf(Vec3 direction) const {
  if (distant_.empty() || distant_.back().lamp) return 0;
  return sky_.pdf(direction) * distant_.back().chance;
}

}  // namespace aktina
