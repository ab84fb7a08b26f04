#include "aktina/radiosity/solver/hierarchy/flat_polygon.h"

namespace aktina {

void cut_by_line(FlatPolygon& polygon, double a, double b, double c) {
  FlatPolygon kept;
  for (size_t k = 0; k < polygon.size(); ++k) {
    const Vec2d p = polygon[k], q = polygon[(k + 1) % polygon.size()];
    const double dp = a + b * p.x + c * p.y, dq = a + b * q.x + c * q.y;
    if (dp >= 0) kept.push_back(p);
    if ((dp >= 0) != (dq >= 0)) kept.push_back(p + (q - p) * (dp / (dp - dq)));
  }
  polygon = std::move(kept);
}

void cut_by_reference(FlatPolygon& polygon, bool triangle) {
  cut_by_line(polygon, 0, 1, 0), cut_by_line(polygon, 0, 0, 1);
  if (triangle)
    cut_by_line(polygon, 1, -1, -1);
  else
    cut_by_line(polygon, 1, -1, 0), cut_by_line(polygon, 1, 0, -1);
}

}  // namespace aktina
