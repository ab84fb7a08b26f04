// The lighting of constant shading: a lamp at the viewer's place, no highlight, no distance. One value a polygon does
// for it. Cost: one dot product a light. Weakness: direction and place of lamps have no effect.
//
// D. Hearn, M. P. Baker, Computer Graphics, C Version, 2nd ed., 1997, section 14-2.
#include "aktina/illumination/constant.h"

#include "aktina/illumination/model.h"

namespace aktina {

Reflectance Constant::brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const {
  const float n_wi = dot(n, wi), n_wo = dot(n, wo);
  if (n_wi <= 0 || n_wo <= 0) return {};
  return {s.kd * (float(kInvPi) * n_wo / n_wi), Rgb()};
}

extern constinit const Method<IlluminationModel> constant_illumination = {
    {"constant", "Constant lighting", "hearn1997",
     "Ambient light and a lamp at the viewer's place: one dot product; where lamps stand has no effect."},
    [](const ParamSet&) -> IlluminationModel { return Constant{}; }};

}  // namespace aktina
