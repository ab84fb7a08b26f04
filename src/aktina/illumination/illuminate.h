// The illumination equation at one point, in its readable form: what Illuminator computes many points at a time.
#pragma once

#include <span>

#include "aktina/base/quantity.h"
#include "aktina/illumination/light/light.h"
#include "aktina/illumination/model.h"

namespace aktina {

/// Where a picture is seen from: a point, or a direction where the viewer is infinitely far away.
struct Viewer {
  Vec3 at{0};  // m; or unit, towards the viewer
  bool distant = false;
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
/// @param ambient  Ia, cd/m^2; @param x  m, world; @param n, wo  unit
Lit illuminate(const IlluminationModel& model, const Surface& surface, std::span<const Light> lights, Rgb ambient,
               Point3 x, Vec3 n, Vec3 wo);

}  // namespace aktina
