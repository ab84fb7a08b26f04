#include "aktina/illumination/illuminate.h"

#include "aktina/base/error.h"

namespace aktina {

void check(const DepthCue& cue) {
  const bool good = cue.k1 >= 0 && cue.k2 >= 0 && cue.k1 < kInfinity && cue.k2 < kInfinity && cue.k1 + cue.k2 > 0;
  if (!good) throw Error(Code::bad_param, "depth_cue", "k1 and k2 should be finite and not below 0, one of them above");
}

Lit illuminate(const IlluminationModel& model, const Surface& surface, std::span<const Light> lights, Rgb ambient,
               Point3 x, Vec3 n, Vec3 wo, float cue) {
  Lit lit{surface.ka * ambient, Rgb()};
  for (const Light& light : lights) {
    const LightSample s = sample(light, x);
    const Reflectance f = brdf_cosine(model, surface, n, s.wi, wo);
    lit.diffuse += f.diffuse * s.e_perp.v * cue;
    lit.specular += f.specular * s.e_perp.v * cue;
  }
  return lit;
}

}  // namespace aktina
