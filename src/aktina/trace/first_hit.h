// The layers of a picture that do not depend on light: what the ray through a pixel's centre meets.
#pragma once

#include "aktina/image/image.h"
#include "aktina/trace/camera_rays.h"
#include "aktina/trace/ray_scene.h"
#include "aktina/trace/trace.h"

namespace aktina {

/// Adds the layers albedo, N, P and Z that the options ask for. Surfaces whose alpha is below a half are looked
/// through, as the rasterizer does.
void add_first_hit_layers(const RayScene& scene, const CameraRays& camera, const TraceOptions& options,
                          LayeredImage& picture);

/// What a ray meets beyond surfaces whose alpha is below a half. @return  false: nothing
bool first_solid_hit(const RayScene& scene, Ray ray, ShadingPoint& out);

}  // namespace aktina
