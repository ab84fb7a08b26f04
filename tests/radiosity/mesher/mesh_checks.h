// What every mesh that light is computed on must be.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "aktina/radiosity/solution.h"
#include "aktina/scene/weld.h"

namespace aktina {

inline double total_area(const PatchMesh& mesh) { return std::accumulate(mesh.areas.begin(), mesh.areas.end(), 0.0); }

/// How many patches each edge has, by the places of its ends.
inline std::map<std::pair<uint32_t, uint32_t>, int> edges(const PatchMesh& mesh) {
  const std::vector<uint32_t> same = weld(mesh.positions);
  std::map<std::pair<uint32_t, uint32_t>, int> count;
  for (size_t i = 0; i < mesh.size(); ++i) {
    const auto& p = mesh.patches[i];
    const size_t n = mesh.is_quad(i) ? 4 : 3;
    for (size_t k = 0; k < n; ++k) ++count[std::minmax(same[p[k]], same[p[(k + 1) % n]])];
  }
  return count;
}

inline void expect_closed(const PatchMesh& mesh) {
  size_t open = 0;
  for (const auto& [edge, count] : edges(mesh)) open += count != 2;
  EXPECT_EQ(open, 0U) << "a crack or a T-junction";
}

}  // namespace aktina
