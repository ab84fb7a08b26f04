// Ray against sphere: a quadratic equation. Cost: one square root. Weakness: cancels in the textbook form when the
// sphere is far or large; here the discriminant is taken from the distance of the centre to the line.
//
// E. Haines, J. Guenther, T. Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems,
// 2019; J. Goldstein, R. Nagel, "3-D Visual Simulation", Simulation 16(1), 1971.
#include "aktina/trace/primitive/primitive.h"
#include "aktina/trace/primitive/quadratic.h"

namespace aktina {

std::optional<SurfaceHit> intersect_sphere(const Line& line, Point3d centre, double radius) {
  const Vec3d f = line.origin - centre, d = line.direction;
  const double a = dot(d, d), b = dot(f, d);
  if (!(a > 0)) return std::nullopt;
  const Vec3d foot = f - (b / a) * d;  // from the centre to the nearest point of the line
  const Roots roots = solve_quadratic(a, b, dot(f, f) - radius * radius, a * (radius * radius - dot(foot, foot)));
  for (int i = 0; i < roots.count; ++i)
    if (line.contains(roots.t[i])) return SurfaceHit{roots.t[i], normalize(f + roots.t[i] * d)};
  return std::nullopt;
}

std::optional<SurfaceHit> intersect(const Sphere& sphere, const Line& line) {
  return intersect_sphere(line, Point3d(0), double(sphere.radius));
}

namespace {
constexpr Param kParams[] = {{"radius", "m", "radius", 1, 0, 1e9}};
}
extern constinit const Method<Primitive> sphere_primitive = {
    {"sphere", "Sphere", "goldstein1971", "About the origin; one square root a ray.", kParams},
    [](const ParamSet& p) -> Primitive { return Sphere{float(p["radius"])}; }};

}  // namespace aktina
