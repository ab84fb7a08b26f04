// Ray against the side of a cone or frustum, x^2 + z^2 = (r + k y)^2 with k = (r_top - r) / h: a quadratic equation.
// Cost: one square root. Weakness: open; at the apex the normal is the axis.
//
// A. S. Glassner (ed.), An Introduction to Ray Tracing, Academic Press, 1989.
#include "aktina/trace/primitive/primitive.h"
#include "aktina/trace/primitive/quadratic.h"

namespace aktina {

std::optional<SurfaceHit> intersect(const Cone& cone, const Line& line) {
  const double r = cone.radius, h = cone.height, k = h > 0 ? (double(cone.top_radius) - r) / h : 0;
  const Vec3d o = line.origin, d = line.direction;
  const double radius = r + k * o.y, slope = k * d.y;  // of the cone along the line: radius + slope t
  const double a = d.x * d.x + d.z * d.z - slope * slope, b = o.x * d.x + o.z * d.z - radius * slope;
  const double c = o.x * o.x + o.z * o.z - radius * radius;
  const Roots roots = solve_quadratic(a, b, c, b * b - a * c);
  for (int i = 0; i < roots.count; ++i) {
    const double t = roots.t[i];
    const Point3d p = line.at(t);
    if (!line.contains(t) || !(p.y >= 0 && p.y <= h)) continue;
    const Vec3d n(p.x, -k * (r + k * p.y), p.z);
    const double n2 = dot(n, n);
    return SurfaceHit{t, n2 > 0 ? n / std::sqrt(n2) : Vec3d(0, k > 0 ? -1 : 1, 0)};
  }
  return std::nullopt;
}

namespace {
constexpr Param kParams[] = {{"radius", "m", "at y = 0", 0.5, 0, 1e9},
                             {"top_radius", "m", "at y = height", 0, 0, 1e9},
                             {"height", "m", "along +y", 1, 0, 1e9}};
}
extern constinit const Method<Primitive> cone_primitive = {
    {"cone", "Cone", "glassner1989", "Cone or frustum about +y, open at both ends; one square root a ray.", kParams},
    [](const ParamSet& p) -> Primitive {
      return Cone{float(p["radius"]), float(p["top_radius"]), float(p["height"])};
    }};

}  // namespace aktina
