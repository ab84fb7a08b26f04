// The lights of a scene, one by one or all together: whose light is computed apart.
#pragma once

#include <string>
#include <vector>

#include "aktina/radiosity/solver/sides.h"
#include "aktina/scene/scene.h"

namespace aktina {

/// Lights that shine together: lamps, the sky, surfaces.
struct LightGroup {
  std::string name;
  std::vector<PlacedLight> lamps;
  const EnvironmentLight* sky = nullptr;  // null: takes no part
  std::vector<uint8_t> emits;             // by instance: its surfaces take part

  bool has_lamps() const { return !lamps.empty() || sky; }
  /// What the patches of its surfaces emit: the others' are black.
  std::vector<Radiosity> emissions(const PatchMesh& mesh) const;
};

/// All that shines. The scene must outlive what these give.
LightGroup all_lights(const Scene& scene);
/// Each lamp, each object that emits and the sky apart, in this order; those of one name together. Nameless ones are
/// called "lamp 0", "object 0" by their number, the sky "environment".
std::vector<LightGroup> each_light(const Scene& scene, const PatchMesh& mesh);

/// The same sides, of which only those emit that belong to the group: by side and band.
std::vector<double> emissions_of_sides(const LightGroup& lights, const Sides& sides);

}  // namespace aktina
