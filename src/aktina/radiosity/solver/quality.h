// Presets: draft, normal, fine.
#pragma once

#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solve.h"

namespace aktina {

/// Values left at 0 replaced by those of the quality. @throws Error usage (no such quality), bad_param
RadiosityOptions resolved(RadiosityOptions options);

/// @param apart  indirect light is computed on coarser patches
MeshOptions mesh_options(const RadiosityOptions& options, bool apart);

}  // namespace aktina
