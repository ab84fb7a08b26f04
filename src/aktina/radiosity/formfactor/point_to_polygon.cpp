#include "aktina/radiosity/formfactor/point_to_polygon.h"

#include <algorithm>
#include <cmath>

#include "aktina/radiosity/formfactor/quadrature.h"
#include "aktina/radiosity/formfactor/shadow.h"

namespace aktina {
namespace {

constexpr double kFar = 0.01;  // contour's size over its distance; see point_to_contour()

double lambert(Point3d x, Vec3d n, std::span<const Point3d> contour) {
  double sum = 0;
  Vec3d a = contour.back() - x;
  for (const Point3d& vertex : contour) {
    const Vec3d b = vertex - x, g = cross(b, a);  // g points to the n side for the stated orientation
    const double sine = length(g);
    if (sine > 0) sum += std::atan2(sine, dot(a, b)) * dot(n, g) / sine;  // atan2: no acos loss near 0
    a = b;
  }
  return sum / (2 * kPi);
}

/// int cos cos / (pi r^2) over the contour by 3 x 3 points a triangle: relative error (size / distance)^6.
double by_kernel(Point3d x, Vec3d n, std::span<const Point3d> contour) {
  double sum = 0;
  for (size_t i = 1; i + 1 < contour.size(); ++i) {
    const Vec3d b = contour[i] - contour[0], c = contour[i + 1] - contour[0], twice = cross(b, c);
    for (const GaussPoint& u : gauss_legendre(3))
      for (const GaussPoint& v : gauss_legendre(3)) {
        const Vec3d r = contour[0] + u.x * (b + v.x * (c - b)) - x;
        const double squared = squared_length(r);
        sum -= u.weight * v.weight * u.x * dot(n, r) * dot(twice, r) / (squared * squared);
      }
  }
  return sum * kInvPi;
}

}  // namespace

double point_to_contour(Point3d x, Vec3d n, std::span<const Point3d> contour) {
  if (contour.size() < 3) return 0;
  double size = 0;
  for (const Point3d& v : contour) size = std::max(size, squared_length(v - contour[0]));
  return size < kFar * kFar * squared_length(contour[0] - x) ? by_kernel(x, n, contour) : lambert(x, n, contour);
}

double point_to_polygon(Point3d x, Vec3d n, const Face& face) {
  const double margin = rounding(face);
  if (face.plane.height(x) <= margin) return 0;
  const Plane horizon{x, n};
  const double height = horizon.height(face.centre);
  if (height <= -face.radius) return 0;
  const double f = height > face.radius ? point_to_contour(x, n, face.vertices)
                                        : point_to_contour(x, n, clip(face.vertices, horizon, margin));
  return std::clamp(f, 0.0, 1.0);
}

double point_to_polygon(Point3d x, Vec3d n, const Face& face, std::span<const Face* const> occluders) {
  const double unoccluded = point_to_polygon(x, n, face);
  if (unoccluded == 0 || occluders.empty()) return unoccluded;
  return std::clamp(visible_part(x, n, face, occluders).visible, 0.0, unoccluded);
}

FormFactorRow point_to_polygons(Point3d x, Vec3d n, const Faces& faces) {
  n = checked_normal(x, n);
  FormFactorRow row;
  for (size_t j = 0; j < faces.size(); ++j) row.factors.push_back(point_to_polygon(x, n, faces[j], faces.blockers(j)));
  row.errors.assign(faces.size(), 1e-14);
  return row;
}

}  // namespace aktina
