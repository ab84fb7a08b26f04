// Methods that stand a surface over a point, cut it into cells, and ask what is seen through each.
#pragma once

#include <memory>
#include <vector>

#include "aktina/radiosity/formfactor/formfactor.h"

namespace aktina {

/// A cell around a point whose normal is +z.
struct DirectionCell {
  Vec3 direction;  // unit, of its middle
  double factor;   // its delta form factor
};

/// The cell's delta form factor cos_i cos_p area / (pi r^2), its middle at `middle` from the point, its own unit normal
/// `normal`.
DirectionCell direction_cell(Vec3d middle, Vec3d normal, double area);

/// A ray through the middle of each cell; what it hits first gets the cell's delta form factor. A set of cells stands
/// on each of `points` points, spread over the patch by area, turned about the normal at random.
std::unique_ptr<FormFactorMethod> by_cells(std::vector<DirectionCell> cells, uint32_t points, uint32_t seed);

}  // namespace aktina
