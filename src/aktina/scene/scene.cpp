#include "aktina/scene/scene.h"

namespace aktina {

const Material& Scene::material_of(const Instance& instance) const {
  static const Material kDefault;
  const int own = instance.mesh >= 0 ? meshes[size_t(instance.mesh)].material : -1;
  const int index = instance.material >= 0 ? instance.material : own;
  return index >= 0 ? materials[size_t(index)] : kDefault;
}

}  // namespace aktina
