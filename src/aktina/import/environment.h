// Pictures of the surroundings -> light from infinity.
#pragma once

#include <span>
#include <string>

#include "aktina/scene/scene.h"

namespace aktina {

/// An equirectangular picture (HDR, EXR, PFM; PNG, JPEG, WebP, decoded to linear) as environment light: radiance in
/// cd/m^2 once multiplied by `scale`. Values that are not finite or below 0 become 0, with a counted warning.
/// @param rotation  rad about +y, as EnvironmentLight
/// @throws Error bad_input (no picture, nothing in it shines), limit
EnvironmentLight environment_of(std::span<const uint8_t> bytes, const std::string& where, Rgb scale, float rotation,
                                Warnings& warnings);

}  // namespace aktina
