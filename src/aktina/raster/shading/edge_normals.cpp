#include "aktina/raster/shading/edge_normals.h"

namespace aktina {

void sample_edge_normals(const TriangleGroup& t, EdgeNormal middle, const Samples& out) {
  for (int corner = 0; corner < 3; ++corner)
    for (int k = 0; k < 3; ++k) out(corner, k) = t.normal[corner][k];
  for (int edge = 0; edge < 3; ++edge) {
    const int a = edge, b = (edge + 1) % 3;
    const auto at = [](const Lanes(&v)[3], size_t i) { return Vec3(v[0][i], v[1][i], v[2][i]); };
    for (size_t i = 0; i < kLanes; ++i) {
      const Vec3 n = middle(at(t.normal[a], i), at(t.normal[b], i), at(t.position[b], i) - at(t.position[a], i));
      for (int k = 0; k < 3; ++k) out(3 + edge, k)[i] = n[k];
    }
  }
}

}  // namespace aktina
