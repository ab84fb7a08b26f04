#include "aktina/radiosity/formfactor/polygon_to_polygon.h"

#include <algorithm>
#include <cmath>

#include "aktina/radiosity/formfactor/point_to_polygon.h"
#include "aktina/radiosity/formfactor/quadrature.h"

namespace aktina {
namespace {

constexpr double kApart = 8;  // distance over size beyond which the smaller contour is integrated by Gauss points

/// x ln x, and its limit at 0.
double x_log_x(double x) { return x > 0 ? x * std::log(x) : 0; }

struct Edge {
  Point3d from, to;
  Vec3d direction;  // unit
  double length;
};

Edge make_edge(Point3d from, Point3d to) {
  const double norm = length(to - from);
  return {from, to, norm > 0 ? (to - from) / norm : Vec3d(0), norm};
}

/// int over edge i of sigma ln q, where q is the squared distance to the end x of edge j and sigma the coordinate of x
/// along j from the foot of the point of i. With tau along i from the foot of x: q = tau^2 + h^2,
/// sigma = alpha + kappa tau.
double end_term(const Edge& i, const Edge& j, Point3d x) {
  const Point3d foot = i.from + dot(i.direction, x - i.from) * i.direction;
  const double h = length(x - foot), alpha = dot(j.direction, x - foot), kappa = -dot(i.direction, j.direction);
  const auto primitive = [&](Point3d end) {
    const double tau = dot(i.direction, end - x), q = squared_length(end - x);
    const double g = (q > 0 ? tau * std::log(q) : 0) - 2 * tau + 2 * h * std::atan2(tau, h);
    return alpha * g + kappa * 0.5 * (x_log_x(q) - q);
  };
  return primitive(i.to) - primitive(i.from);
}

/// 2 int over edge i of rho theta: distance to the line of j, times the angle at which j is seen.
double angle_term(const Edge& i, const Edge& j) {
  const auto integrand = [&](double t) {
    const Point3d x = i.from + t * i.direction;
    const Vec3d a = j.from - x, b = j.to - x;
    const double twice_area = length(cross(a, j.to - j.from));
    return twice_area > 0 ? twice_area * std::atan2(twice_area, dot(a, b)) : 0;
  };
  // Where the integrand may bend: nearest to the line of j, and level with the ends of j.
  const double along = dot(i.direction, j.direction), skew = 1 - along * along;
  double cuts[5] = {0, i.length, 0, 0, 0};
  if (const Vec3d w = i.from - j.from; skew > 1e-12)
    cuts[2] = std::clamp((along * dot(j.direction, w) - dot(i.direction, w)) / skew, 0.0, i.length);
  if (std::abs(along) > 1e-6) {
    cuts[3] = std::clamp(dot(j.direction, j.from - i.from) / along, 0.0, i.length);
    cuts[4] = std::clamp(dot(j.direction, j.to - i.from) / along, 0.0, i.length);
  }
  std::sort(std::begin(cuts), std::end(cuts));
  const double tolerance = 1e-15 * i.length * j.length * std::min(i.length, j.length);
  double sum = 0;
  for (int k = 0; k < 4; ++k) sum += integrate(integrand, cuts[k], cuts[k + 1], tolerance);
  return 2 * sum / j.length;
}

double log_integral(const Edge& i, const Edge& j) {
  return end_term(i, j, j.to) - end_term(i, j, j.from) - 2 * i.length * j.length + angle_term(i, j);
}

Contour scaled(std::span<const Point3d> contour, Point3d origin, double unit) {
  Contour result;
  for (const Point3d& v : contour) result.push_back((v - origin) / unit);
  return result;
}

std::vector<Edge> edges(const Contour& contour) {
  std::vector<Edge> result;
  for (size_t i = 0; i < contour.size(); ++i)
    if (const Edge e = make_edge(contour[i], contour[(i + 1) % contour.size()]); e.length > 0) result.push_back(e);
  return result;
}

/// The closed form, in units of the distances that occur, so that the logarithms are small.
double by_contours(std::span<const Point3d> a, std::span<const Point3d> b) {
  double unit = 0;
  for (const Point3d& v : b) unit = std::max(unit, length(v - a[0]));
  if (!(unit > 0)) unit = length(a[1] - a[0]);
  const std::vector<Edge> of_a = edges(scaled(a, a[0], unit)), of_b = edges(scaled(b, a[0], unit));
  double sum = 0;
  for (const Edge& i : of_a)
    for (const Edge& j : of_b)
      if (const double cosine = dot(i.direction, j.direction); std::abs(cosine) > 1e-16)
        sum += cosine * (i.length >= j.length ? log_integral(j, i) : log_integral(i, j));
  return sum * unit * unit / (4 * kPi);
}

/// Gauss points on the smaller contour, Lambert's formula for the larger; the points' number follows from the distance.
double by_points(std::span<const Point3d> small, Vec3d normal, std::span<const Point3d> large, double ratio) {
  const int n = std::clamp(int(std::ceil(7 / std::log10(ratio))) + 1, 2, 12);
  double sum = 0;
  for (const SurfaceSample& s : gauss_points(small, normal, n)) sum += s.area * point_to_contour(s.x, normal, large);
  return sum;
}

}  // namespace

double log_integral(Point3d from0, Point3d to0, Point3d from1, Point3d to1, double unit) {
  return log_integral(make_edge(from0 / unit, to0 / unit), make_edge(from1 / unit, to1 / unit)) * unit * unit;
}

double exchange_area(const Face& a, const Face& b, std::span<const Point3d> part_of_a,
                     std::span<const Point3d> part_of_b) {
  if (part_of_a.size() < 3 || part_of_b.size() < 3) return 0;
  const bool a_is_smaller = a.radius <= b.radius;
  const Face &small = a_is_smaller ? a : b, &large = a_is_smaller ? b : a;
  const auto small_part = a_is_smaller ? part_of_a : part_of_b, large_part = a_is_smaller ? part_of_b : part_of_a;
  const double ratio = distance(large, small.centre) / small.radius - 1;
  const double area =
      ratio > kApart ? by_points(small_part, small.plane.normal, large_part, ratio) : by_contours(part_of_a, part_of_b);
  return std::clamp(area, 0.0, std::min(a.area, b.area));
}

FacingParts facing_parts(const Face& a, const Face& b) {
  const double margin = std::max(rounding(a), rounding(b));
  if (a.plane.height(b.centre) <= -b.radius || b.plane.height(a.centre) <= -a.radius) return {};
  FacingParts parts{clip(a.vertices, b.plane, margin), clip(b.vertices, a.plane, margin)};
  return parts.empty() ? FacingParts{} : parts;
}

double exchange_area(const Face& a, const Face& b) {
  const FacingParts parts = facing_parts(a, b);
  return exchange_area(a, b, parts.a, parts.b);
}

}  // namespace aktina
