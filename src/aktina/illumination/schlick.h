#pragma once

#include "aktina/base/method.h"
#include "aktina/base/vec.h"
#include "aktina/illumination/surface.h"

namespace aktina {

/// S(t) = t / (n - n t + t) in place of t^n, for t in [0, 1]. The same slope at t = 1; never below t^n for n >= 1.
inline float schlick_power(float t, float n) {
  const float d = n - n * t + t;
  return t > 0 && d > 0 ? t / d : 0;
}

/// Phong's model, or Blinn's, with that.
struct Schlick {
  bool half = false;  // t = n.h instead of r.wo
  Reflectance brdf(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
  float highlight(const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) const;
};

}  // namespace aktina
