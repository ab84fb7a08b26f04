#include "aktina/scene/tessellate.h"

namespace aktina {

TessellatedScene::TessellatedScene(const Scene& scene) : scene_(&scene) {
  if (scene.primitives.empty()) return;
  own_ = scene;
  const int first = int(scene.meshes.size());
  for (const Primitive& primitive : scene.primitives)
    own_->meshes.push_back(tessellate(primitive, bounds(primitive).diagonal() / 500));
  for (Instance& instance : own_->instances)
    if (instance.primitive >= 0) instance.mesh = first + instance.primitive, instance.primitive = -1;
  own_->primitives.clear();
}

}  // namespace aktina
