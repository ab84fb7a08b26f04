// What a scene gets where its file leaves it out.
#include <cmath>

#include "aktina/scene/scene.h"

namespace aktina {

void add_default_camera(Scene& scene) {
  if (!scene.cameras.empty()) return;
  scene.cameras.push_back(frame(bounds(scene)));
  scene.warnings.add("the file has no camera: one that frames the scene was added");
}

/// A key light from above the first camera's left shoulder, under which a white matt surface that faces it shines
/// 1 cd/m^2, and a dim sky (ambient light for the methods without a sky) that fills the shadows.
void add_default_light(Scene& scene) {
  if (has_light(scene)) return;
  const Mat4 camera = scene.cameras.empty() ? Mat4(1) : scene.cameras.front().to_world;
  const Vec3 towards = normalize(transform_vector(camera, {-0.5f, 1, 1}));
  scene.lights.push_back({"default", DirectionalLight{-towards, Irradiance(Rgb(float(kPi)))}, -1});
  scene.environment.colour = Radiance(Rgb(0.2f));
  scene.ambient = Rgb(0.2f);
  scene.warnings.add("nothing in the file shines: a distant light of 3.14 lx and a sky of 0.2 cd/m^2 were added");
}

bool has_light(const Scene& scene) {
  if (!scene.lights.empty() || scene.environment.shines() || !is_black(scene.ambient)) return true;
  for (const Instance& instance : scene.instances) {
    const Material& material = scene.material_of(instance);
    if (material.emits() || material.unlit) return true;
  }
  return false;
}

}  // namespace aktina
