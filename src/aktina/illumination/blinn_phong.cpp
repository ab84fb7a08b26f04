// Diffuse reflection and a highlight about the half vector of light and viewer.
// Cost: half vector (one square root), two dot products and a power a light. Weakness: does not conserve energy.
//
// J. F. Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977.
#include "aktina/illumination/blinn_phong.h"

#include <cmath>

#include "aktina/illumination/model.h"

namespace aktina {

float blinn_highlight(Vec3 n, Vec3 wi, Vec3 wo, float exponent) {
  if (dot(n, wi) <= 0) return 0;
  const float c = dot(n, half_vector(wi, wo, n));
  return c > 0 ? std::pow(c, exponent) : 0;
}

Reflectance BlinnPhong::brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  const float n_wi = dot(n, wi);
  if (n_wi <= 0 || dot(n, wo) <= 0) return {};
  return {s.kd * float(kInvPi), s.ks * (blinn_highlight(n, wi, wo, s.exponent) * float(kInvPi) / n_wi)};
}

extern constinit const Method<IlluminationModel> blinn_phong_illumination = {
    {"blinn_phong", "Blinn-Phong illumination model", "blinn1977",
     "Diffuse reflection and a highlight about the half vector; does not conserve energy."},
    [](const ParamSet&) -> IlluminationModel { return BlinnPhong{}; }};

}  // namespace aktina
