// Where illuminance is asked for: the points at which light meters stand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "aktina/scene/scene.h"

namespace aktina {

inline constexpr size_t kMostMeasuringPoints = 4'000'000;

struct MeasuringField {
  std::string name;
  std::vector<Point3> points;  // m, world
  std::vector<Vec3> normals;   // unit: what the meters face
  std::vector<double> areas;   // m^2 that each point stands for; 1 where points are given one by one
  // Of a grid, rows one after the other: cell (column, row) is the parallelogram `corner` + column u + row v, u, v.
  int columns = 0, rows = 0;
  Point3 corner{0};
  Vec3 u{0}, v{0};  // m
  bool is_grid() const { return columns > 0; }
};

/// Distance of the points of a measuring field, m: 0.2 * 5^log10(d), at most 10, of the longer side d of an area, or of
/// the shorter where the sides differ by a factor of 2 and more (EN 12464-1, "Illuminance grid").
double standard_spacing(double width, double depth);

/// Points in the middle of equal cells over a parallelogram, facing u x v.
/// @param u, v  its sides, m. @param spacing  of the points at most, m; 0: the standard's
/// @throws Error bad_param (no area), limit (kMostMeasuringPoints)
MeasuringField grid(Point3 corner, Vec3 u, Vec3 v, double spacing = 0);

/// A horizontal grid over the bounds of a scene that faces up, its rows running from +z to -z: a plan seen from above.
/// @param height  above the lowest point, m. @param margin  that is left out along the bounds' sides, m; below 0: the
///   standard's, 0.5 m or 15 % of the shorter side, whichever is less
/// @throws Error bad_param (nothing left, outside of the scene), limit
MeasuringField work_plane(const Scene& scene, double height, double margin, double spacing = 0);

/// Points evenly over the front sides of everything whose node, mesh or material has this name.
/// @throws Error bad_param (no such name), limit
MeasuringField surface(const Scene& scene, std::string_view name, double spacing = 0);

}  // namespace aktina
