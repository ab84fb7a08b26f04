// The scene with its meshes cut into the patches of a solution, so that a hit says which vertices it lies between.
#pragma once

#include <array>
#include <vector>

#include "aktina/radiosity/solution.h"
#include "aktina/scene/scene.h"

namespace aktina {

/// @throws Error usage unless the places of the solution lie on the scene (without analytic primitives)
void check_places(const Scene& scene, const Solution& solution);

struct PatchScene {
  /// `scene` may have analytic primitives. @throws Error usage (a solution of another scene)
  PatchScene(const Scene& scene, const Solution& solution);

  Scene scene;                                                 // the same instances and materials
  std::vector<std::vector<std::array<uint32_t, 3>>> vertices;  // of each instance's triangles: vertices of the solution
};

}  // namespace aktina
