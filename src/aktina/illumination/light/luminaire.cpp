// A real luminaire: a point whose intensity in each direction was measured (IES LM-63, EULUMDAT).
// Cost: a point light's, two arc tangents and two binary searches. Weakness: a point, however large the luminaire;
// right from about five times its size, where photometry measures it.
//
// ANSI/IES LM-63-19, "Approved Method: IES Standard File Format for the Electronic Transfer of Photometric Data", 2019.
#include "aktina/illumination/light/light.h"

namespace aktina {

LightSample sample(const LuminaireLight& light, Point3 x) {
  const Vec3 d = light.position - x;
  const float distance = length(d);
  if (!(distance > 0)) return {{0, 0, 1}, 0, Irradiance()};
  const Vec3 wi = d * (1 / distance);
  const float candela = light.table ? intensity(*light.table, light.direction, light.c0, -wi) : 1;
  return {wi, distance, Irradiance(light.colour * (candela / (distance * distance)))};
}

std::optional<Flux> flux(const LuminaireLight& light) {
  return Flux(light.colour * float(light.table ? flux(*light.table) : 4 * kPi));
}

extern constinit const Method<Light> luminaire_light = {
    {"luminaire", "Measured luminaire", "ies2019",
     "A point with the intensity of each direction from a photometric file (IES, EULUMDAT)."},
    [](const ParamSet&) -> Light { return LuminaireLight{}; }};

}  // namespace aktina
