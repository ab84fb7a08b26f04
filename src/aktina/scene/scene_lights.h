// What lights a scene for methods that know lamps only: emissive surfaces as small lamps, the sky as ambient light.
#pragma once

#include <vector>

#include "aktina/scene/scene.h"

namespace aktina {

struct SceneLights {
  std::vector<Light> lights;  // the scene's own, then those that stand for emissive surfaces
  std::vector<int> instance;  // of each light: the instance that it stands for and must not be hidden by; else -1
  Rgb ambient;                // Ia: the scene's own and the mean radiance of the sky, cd/m^2
};

SceneLights scene_lights(const Scene& scene);

}  // namespace aktina
