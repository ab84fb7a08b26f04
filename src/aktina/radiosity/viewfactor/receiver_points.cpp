#include "aktina/radiosity/viewfactor/receiver_points.h"

namespace aktina {
namespace {

/// Quadrilaterals by a bilinear map.
SurfaceSample on_quad(const Point3d* q, double u, double v, double weight) {
  const Vec3d du = (1 - v) * (q[1] - q[0]) + v * (q[2] - q[3]), dv = (1 - u) * (q[3] - q[0]) + u * (q[2] - q[1]);
  return {(1 - u) * ((1 - v) * q[0] + v * q[3]) + u * ((1 - v) * q[1] + v * q[2]), weight * length(cross(du, dv))};
}

/// Triangles by Duffy's map: the first axis is the distance from the first corner.
SurfaceSample on_triangle(const Point3d* q, double u, double v, double weight) {
  const Vec3d b = q[1] - q[0], c = q[2] - q[0];
  return {q[0] + u * ((1 - v) * b + v * c), weight * u * length(cross(b, c))};
}

SurfaceSample on_cell(const Cell& cell, double u, double v, double weight) {
  u = cell.u + cell.du * u, v = cell.v + cell.dv * v, weight *= cell.du * cell.dv;
  return cell.quad ? on_quad(cell.corners.data(), u, v, weight) : on_triangle(cell.corners.data(), u, v, weight);
}

}  // namespace

std::vector<Cell> cells_of(std::span<const Point3d> polygon) {
  std::vector<Cell> cells;
  for (size_t k = 1; k + 1 < polygon.size(); k += 2) {
    const bool quad = k + 2 < polygon.size();
    cells.push_back({{polygon[0], polygon[k], polygon[k + 1], polygon[quad ? k + 2 : k + 1]}, quad});
  }
  return cells;
}

void add_gauss_points(std::span<const Point3d> polygon, int n, std::vector<SurfaceSample>& points) {
  for (const Cell& cell : cells_of(polygon))
    for (const GaussPoint& u : gauss_legendre(n))
      for (const GaussPoint& v : gauss_legendre(n)) points.push_back(on_cell(cell, u.x, v.x, u.weight * v.weight));
}

std::array<SurfaceSample, 16> gauss_points(const Cell& cell) {
  std::array<SurfaceSample, 16> points;
  const std::span<const GaussPoint> rule = gauss_legendre(4);
  const Point3d* q = cell.corners.data();
  const Vec3d u = cell.du * (q[1] - q[0]), v = cell.dv * (q[3] - q[0]);
  const Vec3d skew = q[0] - q[1] + q[2] - q[3];
  if (cell.quad && squared_length(skew) <= 1e-24 * squared_length(q[2] - q[0])) {  // a parallelogram: most are
    const Point3d o = q[0] + cell.u * (q[1] - q[0]) + cell.v * (q[3] - q[0]);
    const double area = length(cross(u, v));
    for (size_t i = 0; i < 4; ++i)
      for (size_t k = 0; k < 4; ++k)
        points[4 * i + k] = {o + rule[i].x * u + rule[k].x * v, rule[i].weight * rule[k].weight * area};
    return points;
  }
  for (size_t i = 0; i < 4; ++i)
    for (size_t k = 0; k < 4; ++k)
      points[4 * i + k] = on_cell(cell, rule[i].x, rule[k].x, rule[i].weight * rule[k].weight);
  return points;
}

std::array<SurfaceSample, 16> border_points(const Cell& cell) {
  std::array<SurfaceSample, 16> points;
  for (size_t k = 0; k < 4; ++k) {
    const double t = 0.25 * double(k);
    points[k] = on_cell(cell, t, 0, 1), points[4 + k] = on_cell(cell, 1, t, 1);
    points[8 + k] = on_cell(cell, 1 - t, 1, 1), points[12 + k] = on_cell(cell, 0, 1 - t, 1);
  }
  for (SurfaceSample& point : points) point.area = 1;
  return points;
}

}  // namespace aktina
