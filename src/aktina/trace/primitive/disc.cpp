// Ray against disc: the plane y = 0, then the distance from its centre. Cost: one division. Weakness: none.
//
// A. S. Glassner (ed.), An Introduction to Ray Tracing, Academic Press, 1989.
#include "aktina/trace/primitive/primitive.h"

namespace aktina {

std::optional<SurfaceHit> intersect(const Disc& disc, const Line& line) {
  const double t = -line.origin.y / line.direction.y;
  if (line.direction.y == 0 || !line.contains(t)) return std::nullopt;
  const Point3d p = line.at(t);
  if (!(p.x * p.x + p.z * p.z <= double(disc.radius) * double(disc.radius))) return std::nullopt;
  return SurfaceHit{t, {0, 1, 0}};
}

namespace {
constexpr Param kParams[] = {{"radius", "m", "radius", 1, 0, 1e9}};
}
extern constinit const Method<Primitive> disc_primitive = {
    {"disc", "Disc", "glassner1989", "In the plane y = 0, front towards +y; one division a ray.", kParams},
    [](const ParamSet& p) -> Primitive { return Disc{float(p["radius"])}; }};

}  // namespace aktina
