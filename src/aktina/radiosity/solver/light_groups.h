// The lights of a scene, one by one or all together: whose light is computed apart.
#pragma once

#include <string>
#include <vector>

#include "aktina/radiosity/solution.h"
#include "aktina/scene/scene.h"

namespace aktina {

/// Lights that shine together: lamps, the sky, surfaces.
struct LightGroup {
  std::string name;
  std::vector<PlacedLight> lamps;
  const EnvironmentLight* sky = nullptr;  // null: takes no part
  std::vector<uint8_t> emits;             // by instance: its surfaces take part

  bool has_lamps() const { return !lamps.empty() || sky; }
  /// Of a patch of its surfaces; other patches are black.
  Radiosity emission(const PatchMesh& mesh, size_t patch) const {
    return emits[mesh.centres[patch].instance] ? mesh.emissions[patch] : Radiosity();
  }
};

/// All that shines. The scene must outlive what these give.
LightGroup all_lights(const Scene& scene);
/// Each lamp, each object that emits and the sky apart, in this order; those of one name together. Nameless ones are
/// called "lamp 0", "object 0" by their number, the sky "environment".
std::vector<LightGroup> each_light(const Scene& scene);

}  // namespace aktina
