#pragma once

#include "aktina/base/method.h"
#include "aktina/base/vec.h"
#include "aktina/illumination/surface.h"

namespace aktina {

/// f = kd / pi + ks exp(-[(h.t / ax)^2 + (h.b / ay)^2] / (h.n)^2) / (4 pi ax ay sqrt((n.wi)(n.wo))). sr^-1
/// The scratches run along t, the direction on the surface across the world's y axis: rings about it, as on turned
/// metal. Where the normal is that axis itself, along x.
struct Ward {
  static constexpr float kLeast = 1e-12f;  // of (n.wi)(n.wo): beyond it the root has no digits
  float along = 0, across = 0;  // ax, ay: slopes along and across the scratches; 0: the material's roughness squared
  Vec2 widths(const Surface& s) const;
  Reflectance brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
};

}  // namespace aktina
