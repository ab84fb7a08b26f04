#include "aktina/radiosity/formfactor/closed_forms.h"

#include <algorithm>
#include <cmath>

#include "aktina/radiosity/formfactor/point_to_polygon.h"

namespace aktina {
namespace {

/// A circle seen from the origin: r(phi) = centre + radius (u cos phi + v sin phi), where v is perpendicular to the
/// centre, so that |r|^2 = p + q cos phi with q >= 0.
struct Circle {
  Vec3d centre, u, v;
  double radius, p, q;
  Vec3d at(double phi) const { return centre + radius * (std::cos(phi) * u + std::sin(phi) * v); }
};

Circle make_circle(Vec3d centre, Vec3d normal, double radius) {
  Vec3d in_plane = centre - dot(centre, normal) * normal;
  in_plane -= dot(in_plane, normal) * normal;  // what rounding has left
  if (!(length(in_plane) > 1e-12 * length(centre)))
    in_plane = cross(normal, std::abs(normal.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0));
  const Vec3d u = normalize(in_plane);
  return {centre, u, cross(normal, u), radius, squared_length(centre) + radius * radius, 2 * radius * dot(centre, u)};
}

/// int over [phi0, phi1], a part of one turn, of (1, cos phi, sin phi) / (p + q cos phi).
Vec3d arc_integrals(const Circle& c, double phi0, double phi1) {
  const double root = std::sqrt((c.p - c.q) * (c.p + c.q)), k = std::sqrt((c.p - c.q) / (c.p + c.q));
  // int dphi / (p + q cos phi) = (phi - 2 lag) / root, where lag = phi/2 - atan(k tan(phi/2)) has no jumps.
  const double k_less = 2 * c.q / ((c.p + c.q) * (1 + k));  // 1 - k without cancellation
  const auto lag = [&](double phi) {
    const double s = std::sin(phi / 2), t = std::cos(phi / 2);
    return std::atan2(k_less * s * t, t * t + k * s * s);
  };
  const double turn = phi1 - phi0, lags = 2 * (lag(phi1) - lag(phi0));
  Vec3d result;
  result[0] = (turn - lags) / root;
  if (c.q < 1e-8 * c.p) {
    result[1] = (std::sin(phi1) - std::sin(phi0)) / c.p -
                c.q / (c.p * c.p) * (turn / 2 + (std::sin(2 * phi1) - std::sin(2 * phi0)) / 4);
    result[2] = -(std::cos(phi1) - std::cos(phi0)) / c.p;
  } else {
    // cos / (p + q cos) = (1 - p / (p + q cos)) / q, with 1 - p / root = -q^2 / (root (root + p)).
    result[1] = -turn * c.q / (root * (root + c.p)) + lags * c.p / (root * c.q);
    result[2] = std::log((c.p + c.q * std::cos(phi0)) / (c.p + c.q * std::cos(phi1))) / c.q;
  }
  return result;
}

/// 1/(2 pi) int n . (dr x r) / r^2 along an arc.
double arc_term(const Circle& c, Vec3d n, double phi0, double phi1) {
  const Vec3d i = arc_integrals(c, phi0, phi1);
  // dr x r = radius (-u sin + v cos) x (centre + radius (u cos + v sin))
  const Vec3d w = cross(c.u, c.v);
  const double sum =
      -dot(n, cross(c.u, c.centre)) * i[2] + dot(n, cross(c.v, c.centre)) * i[1] - c.radius * dot(n, w) * i[0];
  return c.radius * sum / (2 * kPi);
}

double chord_term(Vec3d n, Vec3d from, Vec3d to) {
  const Vec3d g = cross(to, from);
  const double sine = length(g);
  return sine > 0 ? std::atan2(sine, dot(from, to)) * dot(n, g) / (sine * 2 * kPi) : 0;
}

}  // namespace

double point_to_disc(Point3d x, Vec3d n, Point3d centre, Vec3d disc_normal, double radius) {
  const Circle c = make_circle(centre - x, disc_normal, radius);
  if (!(dot(disc_normal, c.centre) < 0)) return 0;
  // Height above the horizon: middle + swing cos(phi - ahead).
  const double middle = dot(n, c.centre), x_part = radius * dot(n, c.u), y_part = radius * dot(n, c.v);
  const double swing = std::hypot(x_part, y_part);
  if (middle <= -swing) return 0;
  if (middle >= swing) return std::clamp(arc_term(c, n, 0, 2 * kPi), 0.0, 1.0);
  const double ahead = std::atan2(y_part, x_part), half = std::acos(std::clamp(-middle / swing, -1.0, 1.0));
  const double from = ahead - half, to = ahead + half;
  return std::clamp(arc_term(c, n, from, to) + chord_term(n, c.at(to), c.at(from)), 0.0, 1.0);
}

double point_to_sphere(double radius, double distance, double angle) {
  const double h = distance / radius, below = std::sqrt((h - 1) * (h + 1)), cosine = std::cos(angle),
               sine = std::sin(angle);
  const double reach = std::asin(1 / h);  // half the angle at which the sphere is seen
  if (angle <= kPi / 2 - reach) return cosine / (h * h);
  if (angle >= kPi / 2 + reach) return 0;
  const double flat = std::acos(std::clamp(-below * cosine / sine, -1.0, 1.0));
  const double root = std::sqrt(std::max(0.0, (1 - h * cosine) * (1 + h * cosine)));
  const double f =
      0.5 - std::asin(std::min(1.0, below / (h * sine))) / kPi + (cosine * flat - below * root) / (kPi * h * h);
  return std::clamp(f, 0.0, 1.0);
}

double coaxial_discs(double radius1, double radius2, double distance) {
  const double a = distance / radius1, b = radius2 / radius1, x = 1 + b * b + a * a;
  // x^2 - 4 b^2 without cancellation.
  const double root = std::sqrt(((1 - b) * (1 - b) + a * a) * ((1 + b) * (1 + b) + a * a));
  return std::min(1.0, 2 * b * b / (x + root));
}

double opposed_rectangles(double a, double b, double distance) {
  const double x = a / distance, y = b / distance, x2 = 1 + x * x, y2 = 1 + y * y, rx = std::sqrt(x2),
               ry = std::sqrt(y2);
  return 2 / (kPi * x * y) *
         (0.5 * std::log(x2 * y2 / (1 + x * x + y * y)) + x * ry * std::atan(x / ry) + y * rx * std::atan(y / rx) -
          x * std::atan(x) - y * std::atan(y));
}

double perpendicular_rectangles(double edge, double from, double to) {
  const double w = from / edge, h = to / edge, w2 = w * w, h2 = h * h, s = w2 + h2, r = std::sqrt(s);
  const double logs = std::log((1 + w2) * (1 + h2) / (1 + s)) + w2 * std::log(w2 * (1 + s) / ((1 + w2) * s)) +
                      h2 * std::log(h2 * (1 + s) / ((1 + h2) * s));
  return (w * std::atan(1 / w) + h * std::atan(1 / h) - r * std::atan(1 / r) + 0.25 * logs) / (kPi * w);
}

double sphere_to_inner_sphere(double inner_radius, double outer_radius) {
  return (inner_radius / outer_radius) * (inner_radius / outer_radius);
}

double sphere_band(double angle1, double angle2) {
  return std::abs(std::sin((angle2 - angle1) / 2) * std::sin((angle1 + angle2) / 2));  // (cos 1 - cos 2) / 2
}

CapFactors spherical_cap(double half_angle) {
  const double cap_cap = std::pow(std::sin(half_angle / 2), 2);  // its share of the sphere
  return {cap_cap, 1 - cap_cap, 1};
}

}  // namespace aktina
