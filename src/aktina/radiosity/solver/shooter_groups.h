// Which shooters are taken together as coarse patches.
#pragma once

#include <cstdint>
#include <vector>

#include "aktina/radiosity/solver/sides.h"
#include "aktina/radiosity/solver/visibility.h"

namespace aktina {

struct ShooterGroups {
  std::vector<uint32_t> first;     // by shooter: the first one of its group
  std::vector<uint8_t> scattered;  // by shooter: it does not hang together with the first one
};

/// Shooters that lie in one cell of a grid and face the same way within about 30 degrees, where they
///  - hang together by their corners and belong to one side of one instance, or
///  - are, with what they hang together with, much smaller than a cell: a cluster of things, whatever they belong to.
/// All are seen from the first of a group: a wall keeps them apart. Shooters longer than half a cell are alone.
/// @param size  m, edge of the cells
/// @param open  by side: the share of its area that light reaches
ShooterGroups group_shooters(const Sides& sides, double size, const std::vector<float>& open,
                             const Visibility& visibility);

}  // namespace aktina
