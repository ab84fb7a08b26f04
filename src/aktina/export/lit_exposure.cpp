#include <algorithm>

#include "aktina/export/lit_gltf.h"

namespace aktina {

float lit_exposure(const Solution& solution) {
  constexpr double kClipped = 0.01;  // share of the area
  struct Patch {
    float brightest;  // of its vertices and channels, lx
    double area;
  };
  std::vector<Patch> patches;
  double total = 0;
  for (size_t i = 0; i < solution.mesh.size(); ++i) {
    if (!is_black(solution.mesh.emissions[i].v)) continue;
    float brightest = 0;
    for (const uint32_t vertex : solution.mesh.patches[i]) {
      brightest = std::max(brightest, max_channel(solution.vertex_irradiances[vertex].v));
      if (solution.mesh.two_sided[i])
        brightest = std::max(brightest, max_channel(solution.vertex_back_irradiances[vertex].v));
    }
    patches.push_back({brightest, double(solution.mesh.areas[i])});
    total += patches.back().area;
  }
  std::sort(patches.begin(), patches.end(), [](const Patch& a, const Patch& b) { return a.brightest > b.brightest; });
  double clipped = 0;
  for (const Patch& patch : patches) {
    clipped += patch.area;
    if (clipped > kClipped * total && patch.brightest > 0) return float(kPi) / patch.brightest;
  }
  return 1;
}

}  // namespace aktina
