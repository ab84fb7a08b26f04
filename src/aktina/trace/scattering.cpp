#include "aktina/trace/scattering.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/random.h"
#include "aktina/illumination/facets.h"
#include "aktina/illumination/ggx.h"

namespace aktina {
namespace {

constexpr float kSmoothRoughness = 0.03f;  // lobes of a tenth of a degree: below what pictures resolve

Vec3 mirrored(Vec3 wo, Vec3 h) { return h * (2 * dot(wo, h)) - wo; }

/// Out of wo's side through facet h; zero at total internal reflection.
Vec3 refracted(Vec3 wo, Vec3 h, float index_ratio) {
  const float c = dot(wo, h), squared_sine = (1 - c * c) / (index_ratio * index_ratio);
  if (!(squared_sine < 1)) return Vec3(0);
  return h * (c / index_ratio - std::sqrt(1 - squared_sine)) - wo / index_ratio;
}

/// Luminance of light that is chosen between: never zero for a colour that is not black.
float weight(Rgb c) { return luminance(c); }

}  // namespace

Scattering::Scattering(const Surface& s) {
  metallic_ = std::clamp(s.metallic, 0.0f, 1.0f);
  const float transmission = std::clamp(s.transmission, 0.0f, 1.0f);
  const Rgb base = clamped(s.base, 0, 1);
  opaque_ = (1 - metallic_) * (1 - transmission);
  glass_ = (1 - metallic_) * transmission;
  body_ = base * opaque_;
  metal_ = clear_ = base;
  f0_ = dielectric_reflectance(s);
  f90_ = std::clamp(s.specular_weight, 0.0f, 1.0f);
  ior_ = std::clamp(s.ior, 1.0f, 10.0f);
  shiny_ = metallic_ > 0 || glass_ > 0 || f90_ > 0;
  const float roughness = std::clamp(s.roughness, 0.0f, 1.0f);
  alpha_ = roughness * roughness;
  // Between equal indices light goes straight on, whatever the facets do.
  smooth_ = shiny_ && (roughness < kSmoothRoughness || (glass_ > 0 && ior_ < 1.001f));
  const FacetAlbedo mean = shiny_ ? mean_facet_albedo(alpha_) : FacetAlbedo{0, 0};
  // Where facets reflect everything, nothing reaches the body.
  const float mean_body_share = shiny_ ? 1 - dielectric_albedo(mean) : 1;
  body_scale_ = mean_body_share > 1e-6f ? 1 / mean_body_share : 0;
  albedo_ = body_ + (metal_ * mean.scale + Rgb(mean.bias)) * metallic_ +
            (f0_ * mean.scale + Rgb(f90_ * mean.bias)) * opaque_ + clear_ * glass_;
  albedo_ = clamped(albedo_, 0, 1);
}

/// E of the opaque dielectric, with light scattered between facets.
float Scattering::dielectric_albedo(FacetAlbedo facets) const {
  const float f0 = max_channel(f0_), single = facets.scale + facets.bias;
  return (f0 * facets.scale + f90_ * facets.bias) * (1 + f0 * (1 / single - 1));
}

Scattering::Interface Scattering::interface(float cosine, float index_ratio) const {
  const FacetAlbedo facets = facet_albedo(alpha_, cosine);
  const float single = facets.scale + facets.bias;
  Interface seen;
  seen.body_share = std::max(0.0f, 1 - dielectric_albedo(facets));
  const Rgb f0 = f0_ * (opaque_ + glass_) + metal_ * metallic_;
  seen.compensation = Rgb(1) + f0 * (1 / single - 1);
  const float passed = glass_ > 0 ? 1 - fresnel_dielectric(cosine, index_ratio) : 0;
  const Rgb reflected = (f0_ * facets.scale + Rgb(f90_ * facets.bias)) * opaque_ +
                        (metal_ * facets.scale + Rgb(facets.bias)) * metallic_ + Rgb(glass_ * (1 - passed));
  const float facet = weight(reflected + clear_ * (glass_ * passed)), body = weight(body_) * seen.body_share;
  seen.chance = is_black(body_) ? 1 : facet / std::max(facet + body, 1e-20f);
  return seen;
}

Rgb Scattering::body_value(Vec3 wi, const Interface& seen) const {
  const float enters = std::max(0.0f, 1 - dielectric_albedo(facet_albedo(alpha_, wi.z)));
  return body_ * (seen.body_share * enters * body_scale_ * wi.z * float(kInvPi));
}

Rgb Scattering::facet_reflectance(float cosine, float index_ratio) const {
  Rgb f = schlick_fresnel(f0_, f90_, cosine) * opaque_ + schlick_fresnel(metal_, 1, cosine) * metallic_;
  if (glass_ > 0) f += Rgb(glass_ * fresnel_dielectric(cosine, index_ratio));
  return f;
}

Rgb Scattering::facet_transmittance(float cosine, float index_ratio) const {
  return glass_ > 0 ? clear_ * (glass_ * (1 - fresnel_dielectric(cosine, index_ratio))) : Rgb(0);
}

ScatterValue Scattering::reflection(Vec3 wo, Vec3 wi, float index_ratio, const Interface& seen) const {
  const Vec3 h = normalize_or(wi + wo, {0, 0, 1});
  const float c = dot(wo, h), d = ggx_distribution(alpha_, h);
  const Rgb f = facet_reflectance(c, index_ratio);
  const float r = weight(f), t = weight(facet_transmittance(c, index_ratio));
  return {f * seen.compensation * (d * ggx_visibility(alpha_, wi.z, wo.z) * wi.z),
          seen.chance * r / std::max(r + t, 1e-20f) * ggx_masking(alpha_, wo.z) * d / (4 * wo.z)};
}

/// Walter et al. 2007, eqs. 16, 17 and 21, for radiance over the square of the index: it stays the same across a
/// boundary, and nothing has to be undone where light leaves a body again.
ScatterValue Scattering::refraction(Vec3 wo, Vec3 wi, float index_ratio, const Interface& seen) const {
  Vec3 h = normalize_or(wo + wi * index_ratio, {0, 0, 1});
  if (h.z < 0) h = -h;
  const float c_o = dot(wo, h), c_i = dot(wi, h);
  if (!(c_o > 0 && c_i < 0)) return {};
  const float jacobian =
      index_ratio * index_ratio * -c_i / std::max((c_o + index_ratio * c_i) * (c_o + index_ratio * c_i), 1e-12f);
  const float visible = ggx_masking(alpha_, wo.z) * ggx_distribution(alpha_, h) * c_o / wo.z * jacobian;
  const Rgb f = facet_transmittance(c_o, index_ratio);
  const float t = weight(f), r = weight(facet_reflectance(c_o, index_ratio));
  return {f * (visible * ggx_masking(alpha_, -wi.z)), seen.chance * t / std::max(r + t, 1e-20f) * visible};
}

ScatterValue Scattering::eval(Vec3 wo, Vec3 wi, bool inside) const {
  if (!(wo.z > 0) || wi.z == 0) return {};
  if (!shiny_) {
    if (wi.z < 0) return {};
    return {body_ * (wi.z * float(kInvPi)), wi.z * float(kInvPi)};
  }
  const float ratio = index_ratio(inside);
  const Interface seen = interface(wo.z, ratio);
  if (wi.z < 0) return smooth_ || glass_ == 0 ? ScatterValue{} : refraction(wo, wi, ratio, seen);
  ScatterValue v = smooth_ ? ScatterValue{} : reflection(wo, wi, ratio, seen);
  v.value += body_value(wi, seen);
  v.pdf += (1 - seen.chance) * wi.z * float(kInvPi);
  return v;
}

ScatterSample Scattering::sample_smooth(Vec3 wo, float choice, float index_ratio, const Interface& seen) const {
  const Rgb f = facet_reflectance(wo.z, index_ratio), passed = facet_transmittance(wo.z, index_ratio);
  const float r = weight(f), t = weight(passed), share = r / std::max(r + t, 1e-20f);
  if (choice < share) return {{-wo.x, -wo.y, wo.z}, f / (share * seen.chance), 0};
  const Vec3 wi = refracted(wo, {0, 0, 1}, index_ratio);
  if (wi == Vec3(0) || !(t > 0)) return {};
  return {wi, passed / ((1 - share) * seen.chance), 0};
}

Vec3 Scattering::sample_facets(Vec3 wo, Vec2 u, float choice, float index_ratio) const {
  const Vec3 h = sample_ggx_normal(alpha_, wo, u);
  const float c = dot(wo, h);
  const float r = weight(facet_reflectance(c, index_ratio)), t = weight(facet_transmittance(c, index_ratio));
  if (choice * (r + t) < r) {
    const Vec3 wi = mirrored(wo, h);
    return wi.z > 0 ? wi : Vec3(0);
  }
  const Vec3 wi = refracted(wo, h, index_ratio);
  return wi.z < 0 ? wi : Vec3(0);
}

ScatterSample Scattering::sample(Vec3 wo, Vec2 u, float choice, bool inside) const {
  if (!(wo.z > 0)) return {};
  if (!shiny_) {
    const Vec3 wi = sample_cosine_hemisphere(u);
    return {wi, body_, std::max(wi.z, 1e-9f) * float(kInvPi)};
  }
  const float ratio = index_ratio(inside);
  const Interface seen = interface(wo.z, ratio);
  ScatterSample s;
  if (u.x < seen.chance) {
    u.x /= seen.chance;
    if (smooth_) return sample_smooth(wo, choice, ratio, seen);
    s.wi = sample_facets(wo, u, choice, ratio);
    if (s.wi == Vec3(0)) return {};
  } else {
    u.x = (u.x - seen.chance) / (1 - seen.chance);
    s.wi = sample_cosine_hemisphere(u);
  }
  const ScatterValue v = eval(wo, s.wi, inside);
  if (!(v.pdf > 0)) return {};
  s.weight = v.value / v.pdf, s.pdf = v.pdf;
  return s;
}

}  // namespace aktina
