// Points of a convex polygon, with the areas that they stand for.
#pragma once

#include <array>
#include <vector>

#include "aktina/radiosity/formfactor/quadrature.h"

namespace aktina {

/// n x n Gauss points in each quadrilateral or triangle of the polygon.
void add_gauss_points(std::span<const Point3d> polygon, int n, std::vector<SurfaceSample>& points);

/// A quadrilateral, or a triangle whose last two corners are equal, and a rectangle of its two coordinates in [0, 1].
struct Cell {
  std::array<Point3d, 4> corners;
  bool quad;
  double u = 0, v = 0, du = 1, dv = 1;

  /// Not of the middle: there a jump between the middle points would go unseen, since all sums of four points in a cell
  /// and in its quarters are the same on either side of it. So cut, they differ by 0.046 of the jump at least.
  Cell quarter(int k) const {
    constexpr double kFirst = 0.454;
    const double left = kFirst * du, below = kFirst * dv;
    Cell part = *this;
    if (k & 1)
      part.u += left, part.du -= left;
    else
      part.du = left;
    if (k >> 1)
      part.v += below, part.dv -= below;
    else
      part.dv = below;
    return part;
  }
};

/// The cells of a convex polygon: one of up to four corners, two of five.
std::vector<Cell> cells_of(std::span<const Point3d> polygon);

/// 4 x 4 Gauss points: no two coordinates of theirs are in a simple ratio, as those of edges often are.
std::array<SurfaceSample, 16> gauss_points(const Cell& cell);

/// Around the cell, corners included; for looking only: of equal areas.
std::array<SurfaceSample, 16> border_points(const Cell& cell);

}  // namespace aktina
