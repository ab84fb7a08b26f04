#include "aktina/scene/weld.h"

#include <bit>

#include "aktina/base/random.h"

namespace aktina {

std::vector<uint32_t> weld(std::span<const Point3> points) {
  constexpr uint32_t kFree = 0xffffffff;
  const size_t slots = std::bit_ceil(points.size() + points.size() / 3 + 1);
  std::vector<uint32_t> table(slots, kFree), first(points.size());
  const auto bits = [](float x) { return std::bit_cast<uint32_t>(x + 0.0f); };
  for (size_t i = 0; i < points.size(); ++i) {
    const Point3 p = points[i];
    size_t slot = hash_combine(hash_combine(hash32(bits(p.x)), bits(p.y)), bits(p.z)) & (slots - 1);
    while (table[slot] != kFree && points[table[slot]] != p) slot = (slot + 1) & (slots - 1);
    if (table[slot] == kFree) table[slot] = uint32_t(i);
    first[i] = table[slot];
  }
  return first;
}

}  // namespace aktina
