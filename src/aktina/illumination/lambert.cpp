// Ideal diffuse reflection: the surface looks equally bright from everywhere.
// Cost: one dot product a light. Weakness: no highlight; real matte surfaces flatten towards the light.
//
// J. H. Lambert, Photometria, 1760.
#include "aktina/illumination/lambert.h"

#include "aktina/illumination/model.h"

namespace aktina {

Reflectance Lambert::brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  if (dot(n, wi) <= 0 || dot(n, wo) <= 0) return {};
  return {s.kd * float(kInvPi), Rgb()};
}

extern constinit const Method<IlluminationModel> lambert_illumination = {
    {"lambert", "Lambert's cosine law", "lambert1760",
     "Ideal diffuse reflection, one dot product a light; no highlight."},
    [](const ParamSet&) -> IlluminationModel { return Lambert{}; }};

}  // namespace aktina
