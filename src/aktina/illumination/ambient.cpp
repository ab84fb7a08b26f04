// Light from everywhere alone: each surface in one tone. Cost: nothing a light. Weakness: no shape is seen.
//
// D. Hearn, M. P. Baker, Computer Graphics, C Version, 2nd ed., 1997, section 14-2.
#include "aktina/illumination/ambient.h"

#include "aktina/illumination/model.h"

namespace aktina {

Reflectance Ambient::brdf(const Surface& /*s*/, Vec3 /*n*/, Vec3 /*wi*/, Vec3 /*wo*/) const { return {}; }

extern constinit const Method<IlluminationModel> ambient_illumination = {
    {"ambient", "Ambient light alone", "hearn1997", "ka Ia: each surface in one tone, whatever the lamps do."},
    [](const ParamSet&) -> IlluminationModel { return Ambient{}; }};

}  // namespace aktina
