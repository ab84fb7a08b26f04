// Which camera a picture is taken with, and how large it becomes.
#pragma once

#include "aktina/scene/scene.h"

namespace aktina {

/// @throws Error usage (the scene has no such camera)
const Camera& chosen_camera(const Scene& scene, int index);

/// Fills in what is 0: by the camera's aspect (1.5 where it leaves that open), `default_width` where both are.
/// @throws Error limit (a picture without pixels, or too large a one)
void fill_size(const Camera& camera, int default_width, int& width, int& height);

}  // namespace aktina
