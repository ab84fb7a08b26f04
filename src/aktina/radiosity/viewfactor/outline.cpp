#include "aktina/radiosity/viewfactor/outline.h"

#include <algorithm>
#include <utility>

namespace aktina {

std::vector<uint32_t> outline_of(std::span<const std::array<uint32_t, 3>> triangles) {
  using Edge = std::pair<uint32_t, uint32_t>;
  std::vector<Edge> all, rim;
  for (const auto& t : triangles)
    for (size_t k = 0; k < 3; ++k) all.emplace_back(t[k], t[(k + 1) % 3]);
  std::sort(all.begin(), all.end());
  if (std::adjacent_find(all.begin(), all.end()) != all.end()) return {};
  for (const Edge& e : all)
    if (!std::binary_search(all.begin(), all.end(), Edge(e.second, e.first))) rim.push_back(e);
  for (size_t i = 1; i < rim.size(); ++i)
    if (rim[i].first == rim[i - 1].first) return {};
  std::vector<uint32_t> corners;
  if (rim.empty()) return corners;
  // Begins at the first corner of the first triangle that is on the rim, so that the order is the file's.
  uint32_t begin = rim[0].first;
  const auto leaving = [&](uint32_t corner) {
    return std::lower_bound(rim.begin(), rim.end(), Edge(corner, 0),
                            [](const Edge& a, const Edge& b) { return a.first < b.first; });
  };
  for (const uint32_t corner : triangles[0])
    if (const auto at = leaving(corner); at != rim.end() && at->first == corner) {
      begin = corner;
      break;
    }
  uint32_t corner = begin;
  do {
    const auto next = leaving(corner);
    if (next == rim.end() || next->first != corner || corners.size() == rim.size()) return {};
    corners.push_back(corner);
    corner = next->second;
  } while (corner != begin);
  if (corners.size() != rim.size()) corners.clear();
  return corners;
}

}  // namespace aktina
