// What a picture may be.
#pragma once

#include "aktina/scene/camera.h"

namespace aktina {

inline constexpr int kMostSide = 16384;  // px

/// @throws Error limit (size), bad_param (a camera without depth)
void check_picture(const Camera& camera, int width, int height);

}  // namespace aktina
