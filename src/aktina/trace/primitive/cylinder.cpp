// Ray against the side of a cylinder: a cone whose radius does not change. Cost: one square root. Weakness: open; two
// discs close it.
//
// A. S. Glassner (ed.), An Introduction to Ray Tracing, Academic Press, 1989.
#include "aktina/trace/primitive/primitive.h"

namespace aktina {

std::optional<SurfaceHit> intersect(const Cylinder& cylinder, const Line& line) {
  return intersect(Cone{cylinder.radius, cylinder.radius, cylinder.height}, line);
}

namespace {
constexpr Param kParams[] = {{"radius", "m", "radius", 0.5, 0, 1e9}, {"height", "m", "along +y", 1, 0, 1e9}};
}
extern constinit const Method<Primitive> cylinder_primitive = {
    {"cylinder", "Cylinder", "glassner1989", "About +y, open at both ends; one square root a ray.", kParams},
    [](const ParamSet& p) -> Primitive {
      return Cylinder{float(p["radius"]), float(p["height"])};
    }};

}  // namespace aktina
