// The mapping between metallic-roughness and classic coefficients: docs/materials.md derives it.
#include "aktina/scene/material.h"

#include <algorithm>
#include <cmath>

#include "aktina/illumination/ggx.h"
#include "aktina/scene/scene.h"

namespace aktina {
namespace {

constexpr float kLargestExponent = 1e4f;         // a lobe of half a degree: narrower than any picture resolves
constexpr float kSharp = 0.1f, kBlurred = 0.3f;  // roughness up to which a mirror is one; from which it is none

Rgb clamp_unit(Rgb c) { return clamped(c, 0, 1); }

/// Width alpha of the microfacet lobe that Phong's exponent matches: Blinn's exponent 2 / alpha^2 - 2 is four times it.
float phong_exponent(float roughness) {
  const float alpha = roughness * roughness;
  return std::min(0.5f * (1 / std::max(alpha * alpha, 1e-8f) - 1), kLargestExponent);
}
float squared_alpha(float exponent) { return 1 / (2 * std::max(exponent, 0.0f) + 1); }

/// Share of what facets reflect that is a sharp picture.
float sharpness(const Surface& s) { return std::clamp((kBlurred - s.roughness) / (kBlurred - kSharp), 0.0f, 1.0f); }

/// Fills the classic coefficients from the physical ones.
void derive_classic(Surface& s) {
  const Rgb f0 = normal_reflectance(s);
  const Rgb body = s.base * (1 - s.metallic);
  s.exponent = phong_exponent(s.roughness);
  s.kd = clamp_unit(body * (1 - s.transmission));
  s.ks = clamp_unit(f0 * (0.25f / squared_alpha(s.exponent)));
  s.kr = f0 * sharpness(s);
  s.ka = matt_reflectance(s);
  s.kt = clamp_unit(body * s.transmission * (Rgb(1) - f0));
}

void state_classic(Surface& s, const ClassicMaterial& c, Rgb tint) {
  s.ka = c.ka * tint, s.kd = c.kd * tint, s.ks = c.ks, s.kr = c.kr, s.kt = c.kt;
  s.exponent = c.exponent;
}

Surface physical(const Material& m) {
  Surface s;
  s.base = m.base_colour;
  s.metallic = m.metallic, s.roughness = m.roughness, s.ior = m.ior;
  s.specular_tint = m.specular_tint, s.specular_weight = m.specular_weight;
  s.transmission = m.transmission;
  return s;
}

float visible_alpha(const Material& m, float alpha) {
  if (m.alpha_mode == AlphaMode::opaque) return 1;
  if (m.alpha_mode == AlphaMode::mask) return alpha >= m.alpha_cutoff ? 1 : 0;
  return std::clamp(alpha, 0.0f, 1.0f);
}

Rgb rgb(Vec4 v) { return {v.x, v.y, v.z}; }

}  // namespace

Rgb matt_reflectance(const Surface& s) {
  const Rgb gloss = normal_reflectance(s) * (1 - sharpness(s));
  return clamp_unit(s.kd * (Rgb(1) - gloss) + gloss);
}

Surface surface_of(const Material& material) {
  Surface s = physical(material);
  derive_classic(s);
  if (material.classic) state_classic(s, *material.classic, Rgb(1));
  return s;
}

MaterialPoint evaluate(const Scene& scene, const Material& m, const Vec2 uv[2], Vec4 colour) {
  const auto read = [&](const Texture& use, bool encoded) {
    return use ? look_up(scene.images[size_t(use.image)], use, uv[use.uv_set], encoded) : Vec4(1);
  };
  const Vec4 base = read(m.base_texture, true) * colour;
  const Vec4 metallic_roughness = read(m.metallic_roughness_texture, false);

  MaterialPoint point;
  Surface& s = point.surface;
  s = physical(m);
  s.base *= rgb(base);
  s.metallic *= metallic_roughness.z, s.roughness *= metallic_roughness.y;
  s.specular_weight *= read(m.specular_texture, false).w;
  s.specular_tint *= rgb(read(m.specular_tint_texture, true));
  s.transmission *= read(m.transmission_texture, false).x;
  derive_classic(s);
  if (m.classic) state_classic(s, *m.classic, rgb(base));

  point.alpha = visible_alpha(m, m.alpha * base.w);
  point.emission = m.emission * rgb(read(m.emission_texture, true));
  if (m.unlit) {
    point.emission = Radiance(s.base);
    s.ka = s.kd = s.ks = s.kr = s.kt = s.base = Rgb(0);
    s.specular_weight = s.transmission = 0;
  }
  return point;
}

Material material_of(const ClassicMaterial& classic) {
  Material m;
  m.classic = classic;
  const float alpha2 = squared_alpha(classic.exponent);
  m.roughness = std::sqrt(std::sqrt(alpha2));
  if (is_black(classic.kd) && is_black(classic.kt) && !is_black(classic.kr)) {  // a mirror: metal
    m.base_colour = classic.kr;
    return m;
  }
  m.metallic = 0;
  m.transmission = std::clamp(max_channel(classic.kt), 0.0f, 1.0f);
  const float body = 1 - m.transmission;
  m.base_colour = clamp_unit(classic.kd * (body > 0 ? 1 / body : 1));
  if (m.transmission > 0 && is_black(classic.kd)) m.base_colour = classic.kt / m.transmission;
  if (classic.index > 1 || m.transmission > 0) m.ior = std::max(classic.index, 1.0f);
  const float dielectric = (m.ior - 1) * (m.ior - 1) / ((m.ior + 1) * (m.ior + 1));
  Rgb f0 = classic.ks * (4 * alpha2);
  for (int i = 0; i < 3; ++i) {  // gloss takes no more than the body leaves
    f0[i] = std::min(f0[i], std::max(1 - classic.kd[i], dielectric));
    f0[i] = std::min(std::max(f0[i], classic.kr[i]), 1.0f);
  }
  m.specular_weight = is_black(f0) || dielectric == 0 ? 0 : 1;
  if (m.specular_weight > 0) m.specular_tint = f0 / dielectric;
  return m;
}

Rgb matt_reflectance(const Material& material) { return matt_reflectance(surface_of(material)); }

}  // namespace aktina
