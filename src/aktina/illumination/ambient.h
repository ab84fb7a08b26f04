#pragma once

#include "aktina/base/method.h"
#include "aktina/base/vec.h"
#include "aktina/illumination/surface.h"

namespace aktina {

/// I = Ia ka, which the lighting equation adds for every model: here there is nothing beside it.
struct Ambient {
  Reflectance brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
};

}  // namespace aktina
