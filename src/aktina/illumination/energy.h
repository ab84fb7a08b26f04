// What a model does with light in all: whether it keeps energy, and whether both ways along a path count the same.
#pragma once

#include "aktina/illumination/model.h"

namespace aktina {

/// Radiance that a viewer sees where everything around has radiance 1 (a white furnace): the integral over the
/// hemisphere of f (n.wi) dwi. Per channel; 1 where a white surface vanishes in the furnace. Relative error about
/// 1e-3; 1e-2 where the viewer grazes the surface.
/// @param cos_view  of the angle between normal and viewer, in (0, 1]; he stands in the plane y = 0 (for Ward's model,
/// whose scratches run along x)
Rgb albedo(const IlluminationModel& model, const Surface& surface, float cos_view);

/// Share of the light of a distant lamp that leaves the surface in any direction: the integral of f (n.wo) dwo. Above 1
/// the model makes light; for a reciprocal model the same as albedo(). Arguments as there.
Rgb reflected_share(const IlluminationModel& model, const Surface& surface, float cos_light);

/// Helmholtz reciprocity: f(wi, wo) = f(wo, wi).
struct Reciprocity {
  float error;  // largest |f(a, b) - f(b, a)| / max of both, over directions between 0 and 85 degrees; 0: reciprocal
  Vec3 a, b;    // where it is so large, n = (0, 0, 1)
};
Reciprocity reciprocity_error(const IlluminationModel& model, const Surface& surface);

}  // namespace aktina
