// Illuminance of the scene's lamps and sky on patches, with shadows.
#pragma once

#include <vector>

#include "aktina/base/progress.h"
#include "aktina/radiosity/solver/sides.h"
#include "aktina/radiosity/solver/visibility.h"
#include "aktina/scene/scene.h"

namespace aktina {

/// Whether the scene has lamps or a sky (emissive surfaces are not meant).
bool has_lamps(const Scene& scene);

/// H0 of each side and of three bands, lx: averages over places spread over the patch, a shadow ray each. Empty where
/// the scene has no lamps. The same values for any number of threads; what is done when `progress` is cancelled.
std::vector<double> direct_light(const Scene& scene, const Sides& sides, const Visibility& visibility, uint32_t seed,
                                 Progress* progress);

}  // namespace aktina
