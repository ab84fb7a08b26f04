// Half and quarter distributions -> all around.
#pragma once

#include "aktina/illumination/light/photometric_table.h"

namespace aktina {

/// Completes planes that run from 0 to 90 (mirrored twice), 0 to 180 or 90 to 270 (mirrored once), or to less than 360
/// (the first plane closes the circle). @throws Error bad_param where the planes do none of that
/// @return which symmetry there is, in words
const char* complete_planes(PhotometricTable& table);

}  // namespace aktina
