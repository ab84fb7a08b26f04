#include "aktina/raster/shading/light_lattice.h"

namespace aktina {

void light_lattice(const TriangleGroup& t, const Illuminator& light, const ShadingPlan& plan, const Samples& out) {
  const auto points = lattice(plan.degree);
  for (int corner = 0; corner < 3; ++corner)
    for (int c = 0; c < out.channels(); ++c) out(corner, c) = t.radiance[corner][c];
  for (size_t point = 3; point < points.size(); ++point) {
    Lanes position[3], normal[3], diffuse[3], specular[3];
    t.interpolate(t.position, points[point], plan.perspective, position);
    t.interpolate(t.normal, points[point], plan.perspective, normal);
    light.evaluate(
        {size_t(t.count), {position[0].v, position[1].v, position[2].v}, {normal[0].v, normal[1].v, normal[2].v}},
        {{diffuse[0].v, diffuse[1].v, diffuse[2].v}, {specular[0].v, specular[1].v, specular[2].v}});
    out.store(int(point), diffuse, specular);
  }
}

}  // namespace aktina
