// The illumination equation at one point, in its readable form: what Illuminator computes many points at a time.
#pragma once

#include <span>

#include "aktina/base/quantity.h"
#include "aktina/illumination/light/light.h"
#include "aktina/illumination/model.h"

namespace aktina {

/// Depth cueing: a factor 1 / (k1 + k2 d) on diffuse and specular light, not on ambient light or emission, d the
/// distance from the projection plane, here the one through the eye. By default none.
/// D. Hearn, M. P. Baker, Computer Graphics, C Version, 2nd ed., 1997, section 14-2.
struct DepthCue {
  float k1 = 1, k2 = 0;  // 1, m^-1
  Point3 eye{0};
  Vec3 forward{0};  // unit, along which d grows
  bool active() const { return k1 != 1 || k2 != 0; }
  float at(Point3 x) const {
    const float d = dot(x - eye, forward);
    return depth_cue(k1 > kLeast ? k1 : kLeast, k2, d > 0 ? d : 0);
  }
  static constexpr float kLeast = 1e-6f;  // of k1: in the eye's plane light stays finite
};
/// @throws Error bad_param unless k1 and k2 are finite, not negative, and not both 0
void check(const DepthCue& cue);

/// Where a picture is seen from: a point, or a direction where the viewer is infinitely far away.
struct Viewer {
  Vec3 at{0};  // m; or unit, towards the viewer
  bool distant = false;
  DepthCue cue{};
  Vec3 towards(Point3 x) const { return distant ? at : normalize_or(at - x, {0, 0, 1}); }
};

/// Radiance that a surface sends to the viewer, cd/m^2, apart by lobe.
struct Lit {
  Rgb diffuse, specular;
  Rgb total() const { return diffuse + specular; }
};

/// Light reflected towards `wo`, without shadows:
///
///     L = ka Ia + sum over lights of f(wi, wo) E (n.wi)+
///
/// The ambient part ka Ia counts as diffuse. n may lean away from the viewer, as interpolated normals do at
/// silhouettes: the horizon of the viewer is not asked for.
/// @param ambient  Ia, cd/m^2; @param x  m, world; @param n, wo  unit; @param cue  DepthCue::at(x)
Lit illuminate(const IlluminationModel& model, const Surface& surface, std::span<const Light> lights, Rgb ambient,
               Point3 x, Vec3 n, Vec3 wo, float cue = 1);

}  // namespace aktina
