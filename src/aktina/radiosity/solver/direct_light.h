// Illuminance of lamps and sky on patches, with shadows.
#pragma once

#include <span>
#include <vector>

#include "aktina/base/progress.h"
#include "aktina/radiosity/checkpoint.h"
#include "aktina/radiosity/solver/light_groups.h"
#include "aktina/radiosity/solver/sides.h"
#include "aktina/radiosity/solver/visibility.h"

namespace aktina {

/// H0 of the sides `of`, lx: averages over places spread over the patch, a shadow ray each. The same values for any
/// number of threads; what is done when `progress` is cancelled.
/// @param illuminance  as many values, 0 at first; stay so where there are no lamps
void direct_light(const LightGroup& lights, const Sides& sides, std::span<const uint32_t> of,
                  const Visibility& visibility, uint32_t seed, Progress* progress, KeptList<Rgb>& illuminance);

}  // namespace aktina
