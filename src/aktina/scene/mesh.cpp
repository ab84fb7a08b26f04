#include "aktina/scene/mesh.h"

namespace aktina {

Bounds bounds(const Mesh& mesh) {
  Bounds b;
  for (const Point3 p : mesh.positions) b.add(p);
  return b;
}

}  // namespace aktina
