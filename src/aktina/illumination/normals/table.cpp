// The weightings of vertex normals: the only list.
#include "aktina/illumination/normals/normals.h"

namespace aktina {

extern const Method<FacetWeighting> plain_normals, area_normals, angle_normals, max_normals;

std::span<const Method<FacetWeighting>* const> normals() {
  static constexpr const Method<FacetWeighting>* kTable[] = {&plain_normals, &area_normals, &angle_normals,
                                                             &max_normals};
  return kTable;
}

FacetWeighting default_weighting() { return angle_normals.make(ParamSet(angle_normals.info)); }

Vec3d vertex_normal(FacetWeighting weighting, std::span<const FacetCorner> fan) {
  Vec3d sum(0);
  double total = 0;
  for (const FacetCorner& corner : fan) {
    const Vec3d term = weighting(corner);
    sum += term, total += length(term);
  }
  const double norm = length(sum);
  return norm > 1e-12 * total ? sum / norm : Vec3d(0);
}

}  // namespace aktina
