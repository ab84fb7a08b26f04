// Triangles that were once a polygon -> that polygon.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace aktina {

/// The corners around triangles of one orientation that make up a polygon; empty where their outline is not one closed
/// line that meets each corner once: holes, overlaps, parts that touch in a corner.
std::vector<uint32_t> outline_of(std::span<const std::array<uint32_t, 3>> triangles);

}  // namespace aktina
