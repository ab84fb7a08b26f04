// Diffuse reflection and a highlight about the mirror direction of the light.
// Cost: mirror vector, two dot products and a power a light. Weakness: does not conserve energy, and the highlight of
// a grazing light stays round where a real one stretches.
//
// B. T. Phong, "Illumination for Computer Generated Pictures", Comm. ACM 18(6), 1975.
#include "aktina/illumination/phong.h"

#include <algorithm>
#include <cmath>

#include "aktina/illumination/facets.h"
#include "aktina/illumination/model.h"

namespace aktina {

float phong_highlight(Vec3 n, Vec3 wi, Vec3 wo, float exponent) {
  if (dot(n, wi) <= 0) return 0;
  const float c = dot(reflect_about(n, wi), wo);
  return c > 0 ? std::pow(c, exponent) : 0;
}

float Phong::highlight(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  const float shine = phong_highlight(n, wi, wo, s.exponent);
  return fresnel ? shine * fresnel_dielectric(dot(n, wi), s.ior) : shine;
}

Reflectance Phong::brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  const float n_wi = dot(n, wi);
  if (n_wi <= 0 || dot(n, wo) <= 0) return {};
  return {s.kd * float(kInvPi), s.ks * (highlight(s, n, wi, wo) * float(kInvPi) / n_wi)};
}

namespace {
constexpr Param kParams[] = {{"fresnel", "1",
                              "1: W(theta), Fresnel's reflectance for the material's index, multiplies ks; 0: ks alone",
                              0, 0, 1, true}};
}

extern constinit const Method<IlluminationModel> phong_illumination = {
    {"phong", "Phong's illumination model", "phong1975",
     "Diffuse reflection and a round highlight, one power a light; does not conserve energy.", kParams},
    [](const ParamSet& p) -> IlluminationModel { return Phong{p["fresnel"] != 0}; }};

}  // namespace aktina
