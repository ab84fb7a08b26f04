// Colour spaces of FLIP. White is D65, as sRGB has it.
#pragma once

#include "aktina/base/rgb.h"

namespace aktina::flip {

struct Triple {
  float x, y, z;
};

/// Linear opponent space: achromatic Y, red-green Cx, blue-yellow Cz.
Triple ycxcz(Rgb linear);
Rgb rgb_of_ycxcz(Triple opponent);
/// L*, and a*, b* scaled by 0.01 L*: colours are seen less in the dark (Hunt).
Triple hunt_lab(Rgb linear);
/// |L difference| + distance in (a, b): for large differences.
float hyab(Triple a, Triple b);

}  // namespace aktina::flip
