// Points of a convex polygon of up to five corners, with the areas that they stand for.
#pragma once

#include <array>
#include <vector>

#include "aktina/radiosity/formfactor/quadrature.h"

namespace aktina {

/// n x n Gauss points in each quadrilateral or triangle of the polygon.
void add_gauss_points(std::span<const Point3d> polygon, int n, std::vector<SurfaceSample>& points);

/// A quadrilateral, or a triangle whose last two corners are equal, and a square of its two coordinates in [0, 1].
struct Cell {
  std::array<Point3d, 4> corners;
  bool quad;
  double u = 0, v = 0, size = 1;
  Cell quarter(int k) const { return {corners, quad, u + (k & 1) * size / 2, v + (k >> 1) * size / 2, size / 2}; }
};

/// The one or two cells of a polygon of three to five corners.
std::vector<Cell> cells_of(std::span<const Point3d> polygon);

/// 4 x 4 Gauss points: no two coordinates of theirs are in a simple ratio, as those of edges often are.
std::array<SurfaceSample, 16> gauss_points(const Cell& cell);

/// Around the cell, corners included; for looking only: of equal areas.
std::array<SurfaceSample, 16> border_points(const Cell& cell);

}  // namespace aktina
