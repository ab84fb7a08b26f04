#include "aktina/scene/corners.h"

#include <numeric>

#include "aktina/scene/weld.h"

namespace aktina {

CornersByPlace::CornersByPlace(std::span<const Point3> positions, std::span<const std::array<uint32_t, 3>> triangles)
    : place_(weld(positions)), first_(positions.size() + 1, 0), corners_(3 * triangles.size()) {
  for (const auto& t : triangles)
    for (const uint32_t vertex : t) ++first_[place_[vertex]];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  for (size_t i = triangles.size(); i-- > 0;)  // from the last to the first: each count runs down to its place's start
    for (size_t k = 3; k-- > 0;) corners_[--first_[place_[triangles[i][k]]]] = uint32_t(3 * i + k);
}

}  // namespace aktina
