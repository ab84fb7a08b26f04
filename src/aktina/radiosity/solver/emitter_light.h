// Light straight from emitting surfaces on every side, apart from all other light.
#pragma once

#include <vector>

#include "aktina/base/progress.h"
#include "aktina/radiosity/checkpoint.h"
#include "aktina/radiosity/solver/shot_geometry.h"
#include "aktina/radiosity/solver/visibility.h"

namespace aktina {

/// Adds to the light of the sides, by side, what shooters send to sides: exact factors, shadow rays as many as the
/// shooter's share of the light there asks for. What is done when `progress` is cancelled. The same values for any
/// number of threads.
/// @param geometry   whose receivers are sides
/// @param shooters   which ones
/// @param exitances  of each of them, lm/m^2
/// @param samples    rays of a side to a shooter that gives it all its light; four times as many in half shade
void add_emitter_light(const ShotGeometry& geometry, const Visibility& visibility, std::span<const uint32_t> shooters,
                       std::span<const Rgb> exitances, int samples, uint32_t seed, Progress* progress,
                       KeptList<Rgb>& light);

}  // namespace aktina
