// Gauss-Legendre rules, and integrals by them: over an interval (adaptive), over a contour in a plane.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "aktina/base/function_ref.h"
#include "aktina/radiosity/formfactor/face.h"

namespace aktina {

struct GaussPoint {
  double x, weight;  // on [0, 1]; the weights sum to 1
};

/// The rule of n points, exact for polynomials of degree 2 n - 1. 1 <= n <= 32
std::span<const GaussPoint> gauss_legendre(int n);

/// A point of a surface and the area that it stands for, m^2.
struct SurfaceSample {
  Point3d x;
  double area;
};

/// n x n Gauss points in each triangle of a fan of the contour, the first axis towards the fan's tip (Duffy's map).
/// Areas are signed, so that concave contours come out right; the sum is the contour's area.
/// M. Duffy, "Quadrature over a Pyramid or Cube of Integrands with a Singularity at a Vertex", SIAM J. Numer. Anal. 19,
/// 1982.
std::vector<SurfaceSample> gauss_points(std::span<const Point3d> contour, Vec3d normal, int n);

/// int_a^b f by halving until eight Gauss points and twice eight agree within `tolerance`.
double integrate(FunctionRef<double(double)> f, double a, double b, double tolerance);

}  // namespace aktina
