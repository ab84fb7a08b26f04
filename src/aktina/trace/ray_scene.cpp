#include "aktina/trace/ray_scene.h"

namespace aktina {

RayScene::RayScene(const Scene& s, std::string_view accelerator_choice) : scene(s), surfaces(s), lights(s) {
  if (accelerator_choice.empty()) {
    accelerator = build_accelerator(scene);
  } else {
    accelerator = make_method(accelerators(), "accelerator", accelerator_choice);
    accelerator->build(scene);
  }
}

}  // namespace aktina
