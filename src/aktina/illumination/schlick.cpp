// Phong's highlight without a power: a quotient that has the same height and slope at its peak.
// Cost: two multiply-adds and a division a light. Weakness: the tail is wider, by up to 0.2 of the peak.
//
// C. Schlick, "A Fast Alternative to Phong's Specular Model", Graphics Gems IV, 1994.
#include "aktina/illumination/schlick.h"

#include "aktina/illumination/model.h"

namespace aktina {

float Schlick::highlight(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  if (dot(n, wi) <= 0) return 0;
  const float t = half ? dot(n, half_vector(wi, wo, n)) : dot(reflect_about(n, wi), wo);
  return schlick_power(t < 1 ? t : 1, s.exponent);
}

Reflectance Schlick::brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  const float n_wi = dot(n, wi);
  if (n_wi <= 0 || dot(n, wo) <= 0) return {};
  return {s.kd * float(kInvPi), s.ks * (highlight(s, n, wi, wo) * float(kInvPi) / n_wi)};
}

namespace {
constexpr Param kParams[] = {
    {"half", "1", "1: about the half vector, as Blinn; 0: about the mirror direction, as Phong", 0, 0, 1, true}};
}

extern constinit const Method<IlluminationModel> schlick_illumination = {
    {"schlick", "Schlick's approximation of the highlight", "schlick1994",
     "A quotient in place of Phong's power; wider tails, by up to 0.2 of the peak.", kParams},
    [](const ParamSet& p) -> IlluminationModel { return Schlick{p["half"] != 0}; }};

}  // namespace aktina
