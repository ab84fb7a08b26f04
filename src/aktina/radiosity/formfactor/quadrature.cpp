#include "aktina/radiosity/formfactor/quadrature.h"

namespace aktina {
namespace {

constexpr int kMostPoints = 32;
constexpr int kMostHalvings = 48;

using Rule = std::array<GaussPoint, kMostPoints>;

/// Roots of the Legendre polynomial by Newton's method from Tricomi's estimate.
Rule make_rule(int n) {
  Rule rule{};
  for (int i = 0; i < n; ++i) {
    double z = std::cos(kPi * (i + 0.75) / (n + 0.5)), slope = 1;
    for (int step = 0; step < 8; ++step) {
      double p = 1, previous = 0;
      for (int k = 0; k < n; ++k) {
        const double older = previous;
        previous = p;
        p = ((2 * k + 1) * z * previous - k * older) / (k + 1);
      }
      slope = n * (z * p - previous) / (z * z - 1);
      z -= p / slope;
    }
    rule[size_t(i)] = {0.5 * (1 - z), 1 / ((1 - z * z) * slope * slope)};
  }
  return rule;
}

double gauss8(FunctionRef<double(double)> f, double a, double b) {
  double sum = 0;
  for (const GaussPoint& g : gauss_legendre(8)) sum += g.weight * f(a + g.x * (b - a));
  return sum * (b - a);
}

double refine(FunctionRef<double(double)> f, double a, double b, double whole, double tolerance, int halvings) {
  const double middle = 0.5 * (a + b), left = gauss8(f, a, middle), right = gauss8(f, middle, b);
  if (std::abs(left + right - whole) <= tolerance || halvings == 0) return left + right;
  return refine(f, a, middle, left, tolerance, halvings - 1) + refine(f, middle, b, right, tolerance, halvings - 1);
}

}  // namespace

std::span<const GaussPoint> gauss_legendre(int n) {
  static const std::array<Rule, kMostPoints> rules = [] {
    std::array<Rule, kMostPoints> made{};
    for (int i = 1; i <= kMostPoints; ++i) made[size_t(i - 1)] = make_rule(i);
    return made;
  }();
  return {rules[size_t(n - 1)].data(), size_t(n)};
}

std::vector<SurfaceSample> gauss_points(std::span<const Point3d> contour, Vec3d normal, int n) {
  std::vector<SurfaceSample> points;
  if (contour.size() < 3) return points;
  points.reserve((contour.size() - 2) * size_t(n * n));
  const Point3d tip = contour[0];
  for (size_t i = 1; i + 1 < contour.size(); ++i) {
    const Vec3d b = contour[i] - tip, c = contour[i + 1] - tip;
    const double twice_area = dot(normal, cross(b, c));
    for (const GaussPoint& u : gauss_legendre(n))
      for (const GaussPoint& v : gauss_legendre(n))
        points.push_back({tip + u.x * (b + v.x * (c - b)), twice_area * u.x * u.weight * v.weight});
  }
  return points;
}

double integrate(FunctionRef<double(double)> f, double a, double b, double tolerance) {
  return a == b ? 0 : refine(f, a, b, gauss8(f, a, b), tolerance, kMostHalvings);
}

}  // namespace aktina
