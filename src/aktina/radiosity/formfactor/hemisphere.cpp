// Nusselt's analog: what is seen on the unit hemisphere, projected down on its base, covers the form factor's share of
// the base. Here the base is cut into cells of equal area, so that all count the same: directions through them have the
// density of the cosine. Cost: one ray a cell for a whole row. Weakness: aliasing; patches below a cell are found by
// luck.
//
//     F = covered area of the base / pi;   cells: Shirley and Chiu's map of an n x n grid to the disc
//
// W. Nusselt, "Graphische Bestimmung des Winkelverhaeltnisses bei der Waermestrahlung", Zeitschrift des VDI 72, 1928.
#include <algorithm>
#include <cmath>

#include "aktina/radiosity/formfactor/direction_cells.h"

namespace aktina {
namespace {

/// The point of the unit disc at (x, y) in [-1, 1]^2; areas keep their ratios.
/// P. Shirley, K. Chiu, "A Low Distortion Map Between Disk and Square", J. Graphics Tools 2(3), 1997.
Vec2d on_disc(double x, double y) {
  const bool wide = std::abs(x) > std::abs(y);
  const double r = wide ? x : y;
  if (r == 0) return {0, 0};
  const double angle = wide ? kPi / 4 * (y / x) : kPi / 2 - kPi / 4 * (x / y);
  return {r * std::cos(angle), r * std::sin(angle)};
}

std::vector<DirectionCell> cells(int n) {
  std::vector<DirectionCell> result;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Vec2d p = on_disc((2 * i + 1.0) / n - 1, (2 * j + 1.0) / n - 1);
      const double height = std::sqrt(std::max(0.0, 1 - dot(p, p)));
      result.push_back({Vec3(Vec3d(p.x, p.y, height)), 1.0 / (n * n)});
    }
  return result;
}

constexpr Param kParams[] = {
    {"resolution", "1", "cells along an edge of the square that is mapped to the base", 64, 2, 1024, true},
    {"points", "1", "hemispheres on each patch", 128, 1, 65536, true},
    {"seed", "1", "of the hemispheres' places and rotations", 0, 0, 4294967295.0, true}};

}  // namespace

extern constinit const FormFactorMethodRow hemisphere_formfactor = {
    {"hemisphere", "Hemisphere (Nusselt analog)", "nusselt1928",
     "Cells of equal area on the base of a hemisphere over points of the patch: all count the same; aliasing.",
     kParams},
    [](const ParamSet& params) -> std::unique_ptr<FormFactorMethod> {
      return by_cells(cells(int(params["resolution"])), uint32_t(params["points"]), uint32_t(params["seed"]));
    }};

}  // namespace aktina
