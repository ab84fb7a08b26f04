// Polygons that tests of form factors start from, and slow integrals that they are held to.
#pragma once

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

#include "aktina/radiosity/formfactor/face.h"
#include "aktina/radiosity/formfactor/matrix.h"
#include "aktina/radiosity/formfactor/quadrature.h"

namespace aktina {

/// The unit square in z = 0, front up.
inline Polygon unit_square() { return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}; }

inline Polygon turned_over(Polygon polygon) {
  std::reverse(polygon.vertices.begin(), polygon.vertices.end());
  return polygon;
}
inline Polygon moved(Polygon polygon, Vec3d by, double scale = 1) {
  for (Point3d& v : polygon.vertices) v = scale * (v + by);
  return polygon;
}
/// The unit square's mate at height h, front down.
inline Polygon ceiling(double h) { return turned_over(moved(unit_square(), {0, 0, h})); }
/// Stands on the unit square's edge x = 0, at `angle` (rad) to it.
inline Polygon hinged(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{0, 0, 0}, {0, 1, 0}, {c, 1, s}, {c, 0, s}}};
}

inline Face face(const Polygon& polygon) { return make_face(polygon, "polygon"); }

/// The six walls of [0, a] x [0, b] x [0, c], fronts inside.
inline std::vector<Polygon> box(double a, double b, double c) {
  const Point3d p[8] = {{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}, {0, 0, c}, {a, 0, c}, {a, b, c}, {0, b, c}};
  return {{{p[0], p[1], p[2], p[3]}}, {{p[7], p[6], p[5], p[4]}}, {{p[0], p[4], p[5], p[1]}},
          {{p[1], p[5], p[6], p[2]}}, {{p[2], p[6], p[7], p[3]}}, {{p[3], p[7], p[4], p[0]}}};
}

/// A_a F_ab by n^4 Gauss points of the kernel, clamped; converges where the two are apart.
inline double brute_exchange(const Face& a, const Face& b, int n) {
  double sum = 0;
  for (const Contour& from : a.convex)
    for (const SurfaceSample& p : gauss_points(from, a.plane.normal, n))
      for (const Contour& to : b.convex)
        for (const SurfaceSample& q : gauss_points(to, b.plane.normal, n)) {
          const Vec3d r = q.x - p.x;
          const double squared = squared_length(r),
                       cosines = std::max(0.0, dot(a.plane.normal, r)) * std::max(0.0, -dot(b.plane.normal, r));
          sum += p.area * q.area * cosines / (kPi * squared * squared);
        }
  return sum;
}

/// Of a closed room: all that leaves a face arrives at others.
inline void expect_closed(const FormFactorMatrix& f, size_t faces, double tolerance) {
  for (size_t i = 0; i < faces; ++i) {
    double sum = 0;
    for (size_t j = 0; j < faces; ++j) sum += f.factors[i * faces + j];
    EXPECT_NEAR(sum, 1, tolerance);
    EXPECT_EQ(f.factors[i * faces + i], 0);
  }
}

/// [-1, 1]
inline double random_coordinate() {  // of any size from the first trial on
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-1000000, 1000001)) * 1e-6;
}
inline Vec3d random_vector() { return {random_coordinate(), random_coordinate(), random_coordinate()}; }
/// A triangle within the unit cube around `centre` whose area is at least a hundredth.
inline Polygon random_triangle(Point3d centre) {
  for (;;) {
    Polygon polygon{{centre + random_vector(), centre + random_vector(), centre + random_vector()}};
    if (length(newell_normal(polygon)) > 0.01) return polygon;
  }
}

}  // namespace aktina
