#pragma once

#include "aktina/base/method.h"
#include "aktina/base/vec.h"
#include "aktina/illumination/surface.h"

namespace aktina {

/// I = Ie + Ia ka + Il kd (n.wo)+: light and viewer stand together, infinitely far away, so that whatever is seen is
/// lit, whichever way the lamp really is. Emission and ambient light are added by the lighting equation.
struct Constant {
  Reflectance brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
};

}  // namespace aktina
