// What lights a scene for methods that know lamps only: emissive surfaces as lamps, the sky as ambient light.
#pragma once

#include <optional>
#include <vector>

#include "aktina/scene/scene.h"

namespace aktina {

struct SceneLights {
  std::vector<Light> lights;  // the scene's own, then those that stand for emissive surfaces
  std::vector<int> instance;  // of each light: the instance that it stands for and must not be hidden by; else -1
  Rgb ambient;                // Ia: the scene's own and the mean radiance of the sky, cd/m^2
};

SceneLights scene_lights(const Scene& scene);

/// Adds a light. Rectangles and discs become black surfaces that emit, so that rays see them, paths sample them and
/// radiosity cuts them into patches; scene_lights() finds them again, as it does any such surface of a file. Others go
/// into Scene::lights. @throws Error bad_param (no area, or radiance that is negative or not finite)
void place_light(Scene& scene, const PlacedLight& light);
/// The rectangular or disc light that an emissive instance is: two triangles that make up a parallelogram, or a round
/// disc. None: it is something else.
std::optional<Light> flat_light(const Scene& scene, const Instance& instance);

}  // namespace aktina
