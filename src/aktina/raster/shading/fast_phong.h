// Cosines between vectors that are linear on the screen, to second order about a triangle's centre.
#pragma once

#include <array>

#include "aktina/raster/shading/span_light.h"

namespace aktina {

/// c + x X + y Y + xx X^2 + xy X Y + yy Y^2; products and roots drop what is of higher order.
struct Taylor2 {
  double c = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  double at(double px, double py) const { return c + x * px + y * py + xx * px * px + xy * px * py + yy * py * py; }
};
Taylor2 operator*(const Taylor2& a, const Taylor2& b);
Taylor2 operator*(double s, const Taylor2& a);
Taylor2 operator-(const Taylor2& a, const Taylor2& b);
/// @pre  a.c > 0
Taylor2 inverse_sqrt(const Taylor2& a);

/// x X + y Y + c, X and Y px from the centroid of a triangle on the screen.
struct LinearVector {
  Vec3d x, y, c;
};
/// The one with the given values at the corners. @pre  the triangle has area
LinearVector linear_vector(const Vec2 (&screen)[3], const Vec3 (&values)[3]);

Taylor2 dot(const LinearVector& a, const LinearVector& b);
/// a.b / (|a| |b|) to second order. @pre  neither vanishes at the centroid
Taylor2 cosine_series(const LinearVector& a, const LinearVector& b);

/// The published coefficients T0 .. T5 of n.l / |n| ~ T5 X^2 + T4 X Y + T3 Y^2 + T2 X + T1 Y + T0 with a constant unit
/// l.
std::array<double, 6> bishop_weimer_terms(const LinearVector& n, Vec3d l);

/// The published recurrence along a scanline: I += dI, dI += 2 T5, `count` values from (x, y) on.
std::vector<double> forward_differences(const Taylor2& series, double x, double y, int count);

}  // namespace aktina
