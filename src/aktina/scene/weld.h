// Vertices that stand in the same place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aktina/base/vec.h"

namespace aktina {

/// For each point the index of the first one in exactly the same place (-0 is 0).
std::vector<uint32_t> weld(std::span<const Point3> points);

}  // namespace aktina
