// Parallel light from infinitely far away: the sun. Cost: none per point. Weakness: no penumbra, no distance.
//
// J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, Computer Graphics: Principles and Practice, 2nd ed., 1990.
#include "aktina/illumination/light/light.h"

namespace aktina {

LightSample sample(const DirectionalLight& light, Point3 /*x*/) { return {-light.direction, kInfinity, light.e_perp}; }

std::optional<Flux> flux(const DirectionalLight& /*light*/) { return std::nullopt; }

extern constinit const Method<Light> directional_light = {
    {"directional", "Directional light", "foley1990", "Parallel light of constant illuminance; the sun."},
    [](const ParamSet&) -> Light { return DirectionalLight{}; }};

}  // namespace aktina
