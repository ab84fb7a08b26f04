#include "aktina/illumination/illuminate.h"

namespace aktina {

Lit illuminate(const IlluminationModel& model, const Surface& surface, std::span<const Light> lights, Rgb ambient,
               Point3 x, Vec3 n, Vec3 wo) {
  Lit lit{surface.ka * ambient, Rgb()};
  for (const Light& light : lights) {
    const LightSample s = sample(light, x);
    const Reflectance f = brdf_cosine(model, surface, n, s.wi, wo);
    lit.diffuse += f.diffuse * s.e_perp.v;
    lit.specular += f.specular * s.e_perp.v;
  }
  return lit;
}

}  // namespace aktina
