// The corner of a cube that stands on its tip, over a point: three faces, all alike, in place of the five of a
// hemicube. Cost: three projections a row. Weakness: as the hemicube's; cells along the horizon are cut in the middle.
//
//     normal (1, 1, 1) / sqrt 3; face x = 1:  dF = (1 + y + z) dA / (sqrt 3 pi (1 + y^2 + z^2)^2),  y, z <= 1, 1 + y +
//     z > 0
//
// J. Beran-Koehn, M. Pavicic, "A Cubic Tetrahedral Adaptation of the Hemi-Cube Algorithm", Graphics Gems II, 1991.
#include <cmath>

#include "aktina/radiosity/formfactor/direction_cells.h"

namespace aktina {
namespace {

/// Of the cube's frame, seen in one whose z is the normal.
Vec3d turned(Vec3d v) {
  const Vec3d n = Vec3d(1) / std::sqrt(3.0), t = normalize(Vec3d(1, -1, 0)), b = cross(n, t);
  return {dot(v, t), dot(v, b), dot(v, n)};
}

/// @param n  cells along the legs of a face, which are 3 long
std::vector<DirectionCell> cells(int n) {
  std::vector<DirectionCell> result;
  const double step = 3.0 / n;
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        Vec3d middle(1), normal(0);
        middle[(axis + 1) % 3] = 1 - (i + 0.5) * step, middle[(axis + 2) % 3] = 1 - (j + 0.5) * step;
        normal[axis] = 1;
        if (middle.x + middle.y + middle.z <= 1e-9) continue;
        result.push_back(direction_cell(turned(middle), turned(normal), step * step));
        sum += result.back().factor;
      }
  for (DirectionCell& cell : result) cell.factor /= sum;  // rows of a closed scene sum to 1 exactly
  return result;
}

constexpr Param kParams[] = {{"resolution", "1", "cells along the legs of a face", 40, 2, 4096, true},
                             {"points", "1", "tetrahedra on each patch", 256, 1, 65536, true},
                             {"seed", "1", "of the tetrahedra's places and rotations", 0, 0, 4294967295.0, true}};

}  // namespace

extern constinit const FormFactorMethodRow cubic_tetrahedron_formfactor = {
    {"cubic_tetrahedron", "Cubic tetrahedron", "berankoehn1991",
     "Three faces of a cube's corner over points of the patch: three projections a row, all alike; aliasing.", kParams},
    [](const ParamSet& params) -> std::unique_ptr<FormFactorMethod> {
      return by_cells(cells(int(params["resolution"])), uint32_t(params["points"]), uint32_t(params["seed"]));
    }};

}  // namespace aktina
