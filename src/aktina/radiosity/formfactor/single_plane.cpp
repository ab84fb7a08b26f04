// One plane of cells above a point, parallel to the patch, in place of the five faces of a hemicube: one projection a
// row. Cost: a fifth of the faces for the same cells overhead. Weakness: what is lower than the plane's edge is not
// seen: the share 1 - 1 / (1 + 1 / extent^2) of the light at most, about 1 / extent^2. It is left out, not made up for:
// rows of closed scenes sum to less than 1.
//
//     dF = dA / (pi (x^2 + y^2 + 1)^2),  |x|, |y| <= extent
//
// F. Sillion, C. Puech, "A General Two-Pass Method Integrating Specular and Diffuse Reflection", SIGGRAPH '89.
#include "aktina/radiosity/formfactor/direction_cells.h"

namespace aktina {
namespace {

std::vector<DirectionCell> cells(int n, double extent) {
  std::vector<DirectionCell> result;
  const double step = 2 * extent / n;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      result.push_back(
          direction_cell({(i + 0.5) * step - extent, (j + 0.5) * step - extent, 1}, {0, 0, 1}, step * step));
  return result;
}

constexpr Param kParams[] = {{"resolution", "1", "cells along an edge of the plane", 128, 2, 4096, true},
                             {"extent", "1", "half an edge of the plane over its height", 7, 1, 100},
                             {"points", "1", "planes on each patch", 16, 1, 65536, true},
                             {"seed", "1", "of the planes' places and rotations", 0, 0, 4294967295.0, true}};

}  // namespace

extern constinit const FormFactorMethodRow single_plane_formfactor = {
    {"single_plane", "Single plane", "sillion1989",
     "One plane of cells above points of the patch: one projection a row; what is seen at grazing angles is left out.",
     kParams},
    [](const ParamSet& params) -> std::unique_ptr<FormFactorMethod> {
      return by_cells(cells(int(params["resolution"]), params["extent"]), uint32_t(params["points"]),
                      uint32_t(params["seed"]));
    }};

}  // namespace aktina
